"""Leaves in the current folder what the later steps need of the plan: runs.json and resolution.

They are touched only where they change: what is made from them is then made again."""

import json
import pathlib
import sys

import yaml  # installed with snakemake

sys.dont_write_bytecode = True
import plan  # noqa: E402
from tables import write  # noqa: E402


def leave(path, text):
    if not path.exists() or path.read_text() != text:
        write(path, text)


config = yaml.safe_load(pathlib.Path(sys.argv[1]).read_text())
leave(pathlib.Path("runs.json"), json.dumps(plan.plan_of(config), indent=1))
leave(pathlib.Path("resolution"), f"{config['resolution']}\n")
