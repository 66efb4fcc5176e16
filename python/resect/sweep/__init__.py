"""Sweeps: many operations that differ in some settings, one table in, one table out.

`resect sweep SWEEP.toml` and `python3 -m resect.sweep SWEEP.toml` run one; docs/how-to/sweep.md describes the file.
"""

from resect.sweep.operation import run_row
from resect.sweep.plan import Plan, read_plan
from resect.sweep.table import Journal, read_table, write_table

__all__ = ["Journal", "Plan", "read_plan", "read_table", "run_row", "write_table"]
