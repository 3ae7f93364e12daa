"""Pages name files and folders that exist: what stands in backquotes and begins with a top-level folder."""
import glob
import os
import re

import house

PATH = re.compile(r"`((?:kernel|predicates|surgery|sims|tests|data|papers|\.ci)/[^`\s:]*)(?: [^`]*)?`")


def check(root):
    pages = [name for pattern in ("*.md", "papers/**/*.md", "sims/**/*.md")
             for name in glob.glob(pattern, root_dir=root, recursive=True)]
    found = []
    for page in sorted(pages):
        for number, line in enumerate(house.text_of(root, page).splitlines(), 1):
            for path in PATH.findall(line):
                plain = re.sub(r"\{.*|<.*|…$", "*", path.rstrip("."))
                if not any(glob.glob(os.path.join(root, plain + end)) for end in ("", ".h", ".cpp", ".toml")):
                    found.append(f"{page}:{number}: there is no {path}")
    return found


def self_test(planted):
    planted.plant("kernel/mesh.h", "")
    planted.plant("papers/map.md", "`kernel/mesh`, `kernel/mesh.h`, `kernel/*.h`, `kernel`, `kernel/mesh.h --of`")
    planted.expect_clean()
    planted.plant("README.md", "\nSee `kernel/gone`.")
    planted.expect_fault("README.md:2: there is no kernel/gone")


if __name__ == "__main__":
    house.main(check, self_test)
