#!/usr/bin/env python3
"""Checks that every include points downwards.

Reads tools/layers.txt (which layer may include which, and which foreign headers belong to which
layers) and looks at every #include in src/. Prints file:line for each that breaks a rule and exits
with 1; says how much it looked at otherwise.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'\s*#\s*include\s*(["<])([^">]+)[">]')
# Headers of others that only these layers may know; the pattern is matched at the header's start.
FOREIGN = {
    r"Inventor/": {"inventor", "app"},
    r"(GL|EGL|GLES\d)/": {"inventor", "app"},
    r"(Qt\w*/|Q[A-Z])": {"app"},
    r"assimp/": {"formats"},
    r"toml\+\+/": {"io"},
    r"nlohmann/": {"formats", "skills", "cli"},
    r"CLI/": {"cli"},
    r"curl/": {"cli"},
    r"(tbb|oneapi)/": {"base"},
}


def read_layers(path):
    """{layer: layers it may include}, in the order of the file; each may name only earlier ones, "*" for all of them."""
    allowed = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        name, colon, rest = line.partition(":")
        if not colon or name in allowed:
            sys.exit(f"{path}:{number}: expected one line per layer, \"layer: layers below it\"")
        below = list(allowed) if rest.split() == ["*"] else rest.split()
        unknown = [layer for layer in below if layer not in allowed]
        if unknown:
            sys.exit(f"{path}:{number}: {name} may include {unknown[0]}, which is not above it in the list")
        allowed[name] = set(below)
    return allowed


def violations(source, layer, allowed, text):
    """Yields (line number, sentence) for every include that breaks a rule."""
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        quote, header = match.groups()
        if quote == '"':
            other = header.split("/")[0]
            if "/" not in header or other not in allowed:
                yield number, f'"{header}" is not of the form "layer/file.h"'
            elif other != layer and other not in allowed[layer]:
                yield number, f"{layer} may not include {other} (tools/layers.txt)"
            elif not (source / header).is_file():
                yield number, f'there is no "{header}"'
        for pattern, layers in FOREIGN.items():
            if re.match(pattern, header) and layer not in layers:
                yield number, f"<{header}> belongs to {' and '.join(sorted(layers))} only, not to {layer}"


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT
    allowed = read_layers(root / "tools" / "layers.txt")
    source = root / "src"
    files = sorted(p for p in source.rglob("*") if p.suffix in (".h", ".cpp"))
    broken = 0
    for file in files:
        layer = file.relative_to(source).parts[0]
        if layer not in allowed:
            found = [(1, f"{layer} is no layer of tools/layers.txt")]
        else:
            found = violations(source, layer, allowed, file.read_text())
        for number, sentence in found:
            print(f"{file.relative_to(root)}:{number}: {sentence}")
            broken += 1
    if not files:
        print(f"{source} holds no sources")
        return 1
    if not broken:
        print(f"{len(files)} files of {len(allowed)} layers: every include points downwards")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
