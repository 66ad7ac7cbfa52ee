"""Counts instructions with valgrind's callgrind, and reads what it writes.

[Callgrind] https://valgrind.org/docs/manual/cl-format.html
"""

import collections
import dataclasses
import pathlib
import re
import shutil

from processes import run_checked
from renders import CandelaFailed

# The kernels' door. Its name begins with what it returns, and within it is no function of which
# that is true: whatever matches switches counting on where it begins and off where it ends.
TILE = "candela::TileCounts candela::render_*tile*"


@dataclasses.dataclass
class Profile:
    total: int
    by_object: dict  # path of the program or library -> instructions within it
    by_file: dict  # path of the source file that an instruction came from, inlined or not
    by_function: dict


def count(out, words):
    """Instructions of the process `words` within the kernels' tiles; `out`: where to keep them."""
    if not shutil.which("valgrind"):
        raise CandelaFailed("valgrind is not installed; expected Debian's package valgrind, which "
                            "`tools/setup --dev` installs.")
    out.unlink(missing_ok=True)
    run_checked(["valgrind", "--quiet", "--tool=callgrind", f"--callgrind-out-file={out}",
                 f"--toggle-collect={TILE}", *words], failed=CandelaFailed, writes=[out])
    profile = read(out.read_text())
    if profile.total == 0:
        raise CandelaFailed(f"nothing was counted: no function's name matches '{TILE}'")
    return profile


def read(text):
    names = collections.defaultdict(dict)  # kind -> number -> name
    here = {"ob": "", "fl": "", "fn": ""}
    sums = {kind: collections.Counter() for kind in here}
    is_call = False  # the next line is what the callee cost, counted there already

    for line in text.splitlines():
        if match := re.match(r"(c?)(ob|fl|fi|fe|fn)=\((\d+)\)(?: (.*))?$", line):
            callee, kind, number, name = match.groups()
            kind = "fl" if kind in ("fi", "fe") else kind
            if name is not None:
                names[kind][number] = name
            if not callee:
                here[kind] = names[kind][number]
        elif line.startswith("calls="):
            is_call = True
        elif match := re.match(r"(?:[+-]?\d+|\*|0x[0-9a-f]+) (\d+)$", line):
            if not is_call:
                for kind, name in here.items():
                    sums[kind][name] += int(match[1])
            is_call = False
    return Profile(sum(sums["ob"].values()), *(dict(sums[kind]) for kind in ("ob", "fl", "fn")))


def is_embree(path):
    return pathlib.Path(path).name.startswith("libembree")


def embree_of(profile):
    """Its instructions, and its library's name."""
    own = {path: cost for path, cost in profile.by_object.items() if is_embree(path)}
    return sum(own.values()), ", ".join(sorted(pathlib.Path(path).name for path in own))


def vectors_of(profile):
    """Which version of the functions that there are several of ran: what the emulated processor
    has. Embree chooses by the same processor."""
    found = set()
    for name in profile.by_function:
        if match := re.search(r"\.arch_(x86_64_v\d)", name):
            found.add(match[1].replace("_", "-"))
    return ", ".join(sorted(found)) or "x86-64"
