"""Two crossed equal wires as half-spaces, worn in gross slip: pressures by the conjugate gradients of Polonsky and Keer (1999) on
a grid of square cells, wear summed over a stroke; nothing of Reye is in it."""
import math
import operator

R, P, MU, E_STAR, H, REACH = 1.0, 8.0, 0.6, 210e3 / (2.0 * (1.0 - 0.3 ** 2)), 0.016, 0.19
ROWS, COLUMNS, STEPS = 32, 16, 12                     # cells along x, cells of the half y > 0, increments of a cycle


def love(x, y):
    """Deflection of a half-space at (x, y) by unit pressure on the cell about the origin."""
    total = 0.0
    for s, u in ((1, x + H / 2), (-1, x - H / 2)):
        for t, v in ((1, y + H / 2), (-1, y - H / 2)):
            r = math.hypot(u, v)
            total += s * t * (u * math.log(v + r) + v * math.log(u + r))
    return total / (math.pi * E_STAR)


class Wires:
    """Depths of both on the grid, kept in the frame of the upper wire, which moves along x over the lower one."""

    def __init__(self):
        self.x = [(i - ROWS / 2 + 0.5) * H for i in range(ROWS)]
        self.y = [(j + 0.5) * H for j in range(COLUMNS)]
        self.cells = [(i, j) for i in range(ROWS) for j in range(COLUMNS) if math.hypot(self.x[i], self.y[j]) < REACH]
        kernel = {(i, j): love(i * H, j * H) for i in range(ROWS) for j in range(2 * COLUMNS)}
        self.influence = [[kernel[abs(i - k), abs(j - m)] + kernel[abs(i - k), j + m + 1] for k, m in self.cells] for i, j in self.cells]
        self.upper = [[0.0] * COLUMNS for _ in range(ROWS)]
        self.lower = [[0.0] * COLUMNS for _ in range(ROWS)]
        self.pressures = [[1.0 if self.x[i] ** 2 + self.y[j] ** 2 < 0.0025 else 0.0 for i, j in self.cells] for _ in range(STEPS)]

    def deflection(self, p):
        return [sum(map(operator.mul, row, p)) for row in self.influence]

    def pressure(self, gap, p):
        """Where gap + deflection is even under positive pressures whose sum is the load."""
        cell = 2.0 * H * H
        scale = P / (cell * sum(p))
        p, t, last, go = [q * scale for q in p], [0.0] * len(p), 1.0, 0.0
        for _ in range(200):
            g = list(map(operator.add, self.deflection(p), gap))
            active = [a for a, q in enumerate(p) if q > 0.0]
            mean = sum(g[a] for a in active) / len(active)
            g = [v - mean for v in g]
            norm = sum(g[a] ** 2 for a in active)
            new = [0.0] * len(p)
            for a in active:
                new[a] = g[a] + go * norm / last * t[a]
            t, last = new, norm
            r = self.deflection(t)
            mean = sum(r[a] for a in active) / len(active)
            tau = sum(g[a] * t[a] for a in active) / sum((r[a] - mean) * t[a] for a in active)
            old, p, go = p, [max(q - tau * v, 0.0) for q, v in zip(p, t)], 1.0
            for a, v in enumerate(g):
                if p[a] == 0.0 and v < 0.0:
                    p[a], go = -tau * v, 0.0
            scale = P / (cell * sum(p))
            p = [q * scale for q in p]
            if cell * sum(abs(q - o) for q, o in zip(p, old)) < 1e-4 * P:
                break
        return p

    def moved(self, w, i, j, s):
        """Depth w at the place of cell (i, j) moved along x by s."""
        at = i + s / H
        k = math.floor(at)
        low, high = (w[n][j] if 0 <= n < ROWS else 0.0 for n in (k, k + 1))
        return low + (at - k) * (high - low)

    def cycle(self, stroke, alpha, times):
        """One cycle of amplitude `stroke`, its wear times over; alpha in mm3/mJ."""
        slip = 4.0 * stroke / STEPS
        upper, lower = ([[0.0] * COLUMNS for _ in range(ROWS)] for _ in range(2))
        for n in range(STEPS):
            t = (n + 0.5) / STEPS
            s = stroke * (4.0 * t if t < 0.25 else 2.0 - 4.0 * t if t < 0.75 else 4.0 * t - 4.0)
            gap = [(self.x[i] ** 2 + self.y[j] ** 2) / (2.0 * R) + self.upper[i][j] + self.moved(self.lower, i, j, s) for i, j in self.cells]
            self.pressures[n] = self.pressure(gap, self.pressures[n])
            w = [[0.0] * COLUMNS for _ in range(ROWS)]
            for (i, j), p in zip(self.cells, self.pressures[n]):
                w[i][j] = alpha * MU * p * slip * times
                upper[i][j] += w[i][j]
            for i in range(ROWS):
                for j in range(COLUMNS):
                    lower[i][j] += self.moved(w, i, j, -s)
        for mine, more in ((self.upper, upper), (self.lower, lower)):
            for row, add in zip(mine, more):
                row[:] = map(operator.add, row, add)


def worn(stroke, alpha, cycles):
    """[(cycle, depth of the upper wire, of the lower)] and the wires at the end."""
    wires, done, rows = Wires(), 0.0, []
    while done < cycles - 1e-9:
        times = min(2.0 + 0.05 * done, 60.0, cycles - done)
        wires.cycle(stroke, alpha, times)
        done += times
        rows.append((done, max(map(max, wires.upper)), max(map(max, wires.lower))))
    return rows, wires
