"""Leaves in the current folder what the later steps need of the plan: runs.json and resolution."""

import json
import pathlib
import sys

import yaml  # installed with snakemake

sys.dont_write_bytecode = True
import plan  # noqa: E402
from tables import write  # noqa: E402

config = yaml.safe_load(pathlib.Path(sys.argv[1]).read_text())
write(pathlib.Path("runs.json"), json.dumps(plan.plan_of(config), indent=1))
write(pathlib.Path("resolution"), f"{config['resolution']}\n")
