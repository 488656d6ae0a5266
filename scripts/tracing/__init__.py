"""What scripts/traceability is made of: tags in the sources, the texts they stand before, and which test reaches what."""
