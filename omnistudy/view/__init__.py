"""What is seen: trials as pages in a browser, drawn from the scene description."""
