"""A surgeon's gloved hands, each with the sleeve of the gown, in the grips that instruments
need."""
