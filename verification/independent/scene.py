"""What the evaluations need of a deck: nodes, quads, functions, imposed velocities. A reader of its own, for these decks only."""

from pathlib import Path


def interpolated(table, x):
    """A piecewise linear function, extrapolated beyond both ends."""
    if len(table) == 1:
        return table[0][1]
    i = 0
    while i < len(table) - 2 and x > table[i + 1][0]:
        i += 1
    (x0, y0), (x1, y1) = table[i], table[i + 1]
    return y0 + (y1 - y0) * (x - x0) / (x1 - x0)


def columns(line, width=10):
    return [int(line[i : i + width]) for i in range(0, len(line.rstrip()), width) if line[i : i + width].strip()]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(a):
    return dot(a, a) ** 0.5


def offset_step(own, penetration, cycle):
    """Chapter 6: [P0, cycles of contact] of a node takes up this cycle; the penetration left, and whether a contact begins."""
    begins = own[1] == 0 and cycle > 0
    if begins:
        own[0] = penetration
    own[1] += 1
    own[0] = min(own[0], 0.95 * own[0] + 0.05 * penetration)
    return max(0.0, penetration - own[0]), begins


class Scene:
    """Parts below 100 are the blank, the others the tool."""

    def __init__(self, deck):
        self.blocks, card = {}, None
        for line in Path(deck).read_text().splitlines():
            if line.startswith("/"):
                card = line.strip()
                self.blocks.setdefault(card, [])
            elif card and not line.startswith("#"):
                self.blocks[card].append(line)
        self.x = {int(line.split()[0]): [float(v) for v in line.split()[1:4]] for line in self.blocks["/NODE"]}
        self.functions, self.shell, self.part, self.velocity = {}, {}, {}, {}
        for card, lines in self.blocks.items():
            words = card.split("/")
            if words[1] == "FUNCT":
                self.functions[int(words[2])] = [tuple(map(float, line.split())) for line in lines[1:]]
            elif words[1] == "SHELL":
                for line in lines:
                    number, *corners = columns(line)
                    self.shell[number], self.part[number] = corners[:4], int(words[2])
            elif words[1] == "IMPVEL" and len(lines[1].split()[1]) == 1:
                self.velocity["XYZ".index(lines[1].split()[1])] = (int(lines[1].split()[0]), float(lines[2].split()[1]))
        self.blank = [self.shell[s] for s in self.shell if self.part[s] < 100]
        self.tool = [self.shell[s] for s in self.shell if self.part[s] >= 100]
        self.nodes = sorted({node for quad in self.blank for node in quad})

    def area(self, quad):
        a, b, c, d = (self.x[node] for node in quad)
        return 0.5 * length(cross(minus(c, a), minus(d, b)))

    def shares(self, quads, factor=1.0):
        """{node: a quarter of the area of each of its quads, times the factor}."""
        found = {}
        for quad in quads:
            for node in quad:
                found[node] = found.get(node, 0.0) + factor * self.area(quad) / 4
        return found
