"""Many virtual studies that differ in a few settings: planning, running, going on, choosing."""
