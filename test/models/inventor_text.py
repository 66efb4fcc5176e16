"""Reads the part of Open Inventor's ascii format that the models use, independently of the program
that writes it."""

import re

TOKEN = re.compile(r"[{}\[\]]|[^\s,{}\[\]]+")


def tokens(text):
    if not text.startswith("#Inventor V2.1 ascii\n"):
        raise ValueError("the file does not begin with '#Inventor V2.1 ascii'")
    return TOKEN.findall(re.sub(r"#[^\n]*", "", text))


def read_strips(text):
    """All strips of the file in order, each a list of (position, normal), positions in metres with
    Scale and Translation applied. Raises ValueError where counts do not fit, or for a node or field
    that the models do not use.
    """
    reader = _Reader(tokens(text))
    reader.nodes(_State())
    if reader.at < len(reader.tokens):
        raise ValueError(f"'{reader.tokens[reader.at]}' after the end of the scene")
    return reader.strips


class _State:
    """What a Separator restores: coordinates, normals and the transform p -> factor * p +
    offset."""

    def __init__(self, parent=None):
        self.points = parent.points if parent else []
        self.normals = parent.normals if parent else []
        self.factor = parent.factor if parent else (1.0, 1.0, 1.0)
        self.offset = parent.offset if parent else (0.0, 0.0, 0.0)


class _Reader:
    def __init__(self, token_list):
        self.tokens = token_list
        self.at = 0
        self.strips = []

    def next(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def nodes(self, state):
        while self.at < len(self.tokens) and self.tokens[self.at] != "}":
            kind = self.next()
            if kind == "DEF":
                self.next()
                kind = self.next()
            if self.next() != "{":
                raise ValueError(f"{kind} is not followed by {{")
            if kind == "Separator":
                self.nodes(_State(state))
            else:
                self.leaf(kind, self.fields(), state)
            if self.next() != "}":
                raise ValueError(f"{kind} is not closed")

    def fields(self):
        """{name: list of values}, up to the closing brace."""
        result = {}
        name = None
        while self.tokens[self.at] != "}":
            token = self.next()
            if re.match(r"[A-Za-z]", token) and (name is None or result[name]):
                name = token
                result[name] = []
            elif token not in "[]":
                result[name].append(token)
        return result

    def leaf(self, kind, fields, state):
        if kind == "Coordinate3":
            state.points = _vectors(fields["point"])
        elif kind == "Normal":
            state.normals = _vectors(fields["vector"])
        elif kind == "Scale":
            state.factor = tuple(
                a * b for a, b in zip(state.factor, _vectors(fields["scaleFactor"])[0])
            )
        elif kind == "Translation":
            move = _vectors(fields["translation"])[0]
            state.offset = tuple(o + f * m for o, f, m in zip(state.offset, state.factor, move))
        elif kind == "NormalBinding":
            if fields["value"] != ["PER_VERTEX"]:
                raise ValueError("normals are not bound per vertex")
        elif kind == "ShapeHints":
            if fields != {"vertexOrdering": ["COUNTERCLOCKWISE"], "shapeType": ["SOLID"]}:
                raise ValueError("the shape is not declared counterclockwise and solid")
        elif kind == "TriangleStripSet":
            self.strip_set([int(x) for x in fields["numVertices"]], state)
        elif kind == "Transform":
            # Jaws that the file shows open; the models are checked closed.
            if sorted(fields) != ["center", "rotation"]:
                raise ValueError(f"a Transform with {', '.join(fields)} is not that of a jaw")
        elif kind != "Material":
            raise ValueError(f"unexpected node {kind}")

    def strip_set(self, counts, state):
        if sum(counts) != len(state.points) or len(state.points) != len(state.normals):
            raise ValueError(
                f"{sum(counts)} strip vertices, {len(state.points)} points, "
                f"{len(state.normals)} normals"
            )
        first = 0
        for count in counts:
            if count < 3:
                raise ValueError(f"a strip of {count} vertices")
            placed = [
                tuple(o + f * x for o, f, x in zip(state.offset, state.factor, point))
                for point in state.points[first : first + count]
            ]
            self.strips.append(list(zip(placed, state.normals[first : first + count])))
            first += count


def _vectors(values):
    if len(values) % 3:
        raise ValueError(f"{len(values)} numbers are not a list of vectors")
    return [tuple(float(x) for x in values[i : i + 3]) for i in range(0, len(values), 3)]


def triangles(strips):
    """The strips' triangles as triples of (position, normal), counterclockwise: every second one is
    flipped."""
    result = []
    for strip in strips:
        for k in range(len(strip) - 2):
            a, b, c = strip[k : k + 3]
            result.append((b, a, c) if k % 2 else (a, b, c))
    return result
