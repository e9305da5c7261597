"""What is to be run, as data: models, composition, orders, hashes."""
