"""What code, files and tables call a thing."""

from typing import Annotated

from pydantic import Field

Name = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]*$", max_length=60)]
"""What code, files and tables call a thing: small letters, digits and underscores."""
