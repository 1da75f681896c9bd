"""A rigid ball in a cup whose wall is a bed of springs, confined between ball and shell, worn by Archard's law over steps of a gait."""
import math

R, CLEARANCE, WALL, E, NU, K, FORCE = 14.0, 0.1, 7.9, 800.0, 0.42, 1.0e-9, 3000.0
BED = E * (1.0 - NU) / ((1.0 + NU) * (1.0 - 2.0 * NU)) / WALL     # MPa per mm of approach
LOAD = [(0.0, 0.1), (0.1, 1.0), (0.3, 0.5), (0.5, 1.0), (0.6, 0.1), (1.0, 0.1)]
TURNS = ([(0.0, 0.05), (0.2, 0.122), (0.5, -0.035), (0.6, -0.07), (1.0, 0.05)],            # adduction, about x
         [(0.0, 0.436), (0.1, 0.34), (0.3, -0.09), (0.5, -0.314), (0.6, -0.25), (1.0, 0.436)],   # flexion, about y
         [(0.0, -0.175), (0.5, 0.035), (1.0, -0.175)])                                       # rotation, about z
INCREMENTS, RINGS, SECTORS = 20, 30, 36


def at(table, t):
    for (a, u), (b, v) in zip(table, table[1:]):
        if t <= b:
            return u + (v - u) * (t - a) / (b - a)
    return table[-1][1]


def cells():
    """[(direction from the ball's centre, area)] over the half of the ball below its equator."""
    step, turn = 0.5 * math.pi / RINGS, 2.0 * math.pi / SECTORS
    return [((math.sin(p) * math.cos(q), math.sin(p) * math.sin(q), -math.cos(p)), R * R * math.sin(p) * step * turn)
            for p in ((i + 0.5) * step for i in range(RINGS)) for q in ((j + 0.5) * turn for j in range(SECTORS))]


def increments():
    """[(load at the end in N, turn about x, y, z)] of a step."""
    times = [k / INCREMENTS for k in range(INCREMENTS + 1)]
    return [(FORCE * at(LOAD, v), tuple(at(t, v) - at(t, u) for t in TURNS)) for u, v in zip(times, times[1:])]


def slip(turn, n):
    return R * math.sqrt((turn[1] * n[2] - turn[2] * n[1]) ** 2 + (turn[2] * n[0] - turn[0] * n[2]) ** 2
                         + (turn[0] * n[1] - turn[1] * n[0]) ** 2)


class Cup:
    def __init__(self):
        self.cells = cells()
        self.depth = [0.0] * len(self.cells)

    def pressures(self, force):
        """Of a ball pressed along z with a force."""
        def pressed(d):
            return [max(0.0, BED * (-d * n[2] - CLEARANCE * (1.0 + n[2]) - w)) for (n, _), w in zip(self.cells, self.depth)]
        low, high = 0.0, 3.0
        for _ in range(40):
            d = 0.5 * (low + high)
            total = sum(-p * n[2] * area for p, (n, area) in zip(pressed(d), self.cells))
            low, high = (low, d) if total > force else (d, high)
        return pressed(high)

    def walk(self, steps):
        worn, known = [0.0] * len(self.cells), {}
        for force, turn in increments():
            if force not in known:
                known[force] = self.pressures(force)
            for k, p in enumerate(known[force]):
                if p > 0.0:
                    worn[k] += K * p * slip(turn, self.cells[k][0]) * steps
        self.depth = [a + b for a, b in zip(self.depth, worn)]

    def volume(self):
        return sum(w * area for w, (_, area) in zip(self.depth, self.cells))


def walked(steps, blocks=20):
    """[(step, depth, volume)]; the cup at the end."""
    cup, rows = Cup(), [(0.0, 0.0, 0.0)]
    for k in range(blocks):
        cup.walk(steps / blocks)
        rows.append((steps * (k + 1) / blocks, max(cup.depth), cup.volume()))
    return rows, cup


def way_at_the_pole(steps):
    """K F s where the load stands: what an even cup of no extent would lose."""
    return sum(K * force * slip(turn, (0.0, 0.0, -1.0)) for force, turn in increments()) * steps
