"""FuseSoC generator: makes a shading core of a scene with `specula generate SCENE --ip`.

FuseSoC starts it in an empty folder with the path of a YAML file: what the core is to be called,
where the asking .core file stands, and its parameters, which specula.core lists.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

import yaml

# Parameters that are options of `specula generate` with a value, and those without one.
OPTIONS = ["name", "method", "size", "specialise", "formats", "bound", "max_error",
           "max_quantisation", "target", "clock", "device", "word", "spans"]
FLAGS = ["positions"]


def main(path):
    asked = yaml.safe_load(Path(path).read_text())
    parameters = dict(asked["parameters"] or {})
    bench = parameters.pop("bench", False)
    command = [os.environ.get("SPECULA", "specula"), "generate",
               *arguments(parameters, Path(asked["files_root"])), "--ip", "--output", "."]
    try:
        made = subprocess.run(command, check=False)
    except FileNotFoundError:
        sys.exit(f"specula generator: there is no program `{command[0]}`: see SPECULA in "
                 "specula.core")
    if made.returncode:
        sys.exit(made.returncode)
    [core] = Path().glob("*.core")
    core.write_text(adapted(core.read_text(), asked["vlnv"], bench))


def arguments(parameters, folder):
    """The scene and the options as words of a command; a scene file is one in `folder`."""
    unknown = sorted(set(parameters) - {"scene", *OPTIONS, *FLAGS})
    if unknown or "scene" not in parameters:
        wrong = f"no parameter `{unknown[0]}`" if unknown else "`scene` is missing"
        sys.exit(f"specula generator: {wrong}; there are scene, bench, "
                 + ", ".join(OPTIONS + FLAGS))
    scene = str(parameters["scene"])
    file = folder / scene
    words = [str(file) if file.is_file() else scene]
    for name in OPTIONS:
        if name in parameters:
            words += [f"--{name.replace('_', '-')}", str(parameters[name])]
    return words + [f"--{name}" for name in FLAGS if parameters.get(name)]


def adapted(core, name, bench):
    """The text of a .core file under another name, if asked for with the bench by default."""
    core = re.sub(r"^name: .*$", f"name: {name}", core, count=1, flags=re.MULTILINE)
    if bench:
        core = core.replace("  default:\n    filesets: [rtl]",
                            "  default:\n    filesets: [rtl, bench, vectors]", 1)
    return core


if __name__ == "__main__":
    main(sys.argv[1])
