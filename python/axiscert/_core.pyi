# The bindings, which have no types of their own: the package says what it returns.
from typing import Any

def __getattr__(name: str) -> Any: ...
