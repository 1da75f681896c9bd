"""A rigid pad that tilts freely under its piston and is worn by friction on a turning rigid disc: every turn takes off a wedge,
whose three numbers follow from the force and the two moments about the piston, of the pad as it stands."""
import math

FORCE, MU, ALPHA = 3000.0, 0.4, 2.5e-8                # N; mm3/mJ
WIDTH, LENGTH, THICK, PISTON = 60.0, 40.0, 10.0, (0.0, 97.0)
COLUMNS, ROWS = 60, 40
CELLS = [(-WIDTH / 2 + WIDTH * (i + 0.5) / COLUMNS, 80.0 + LENGTH * (j + 0.5) / ROWS) for i in range(COLUMNS) for j in range(ROWS)]
AREA = WIDTH * LENGTH / (COLUMNS * ROWS)


def solved(rows):
    """The three unknowns of rows [a, b, c, right side]."""
    rows = [list(map(float, row)) for row in rows]
    for i in range(3):
        k = max(range(i, 3), key=lambda n: abs(rows[n][i]))
        rows[i], rows[k] = rows[k], rows[i]
        for n in range(3):
            if n != i:
                factor = rows[n][i] / rows[i][i]
                rows[n] = [u - factor * v for u, v in zip(rows[n], rows[i])]
    return [rows[i][3] / rows[i][i] for i in range(3)]


def depth(wedge, x, y):
    return wedge[0] + wedge[1] * x + wedge[2] * (y - 100.0)


def place(worn, x, y):
    """Where a place of the sole is, from the axis and from the piston: the worn sole lies flat on the disc, so that the pad
    has turned about its piston, and its sole, a lining's thickness below, has moved against the slope of the wedge."""
    arm = THICK - depth(worn, x, y)
    x, y = x - arm * worn[1], y - arm * worn[2]
    return x, y, x - PISTON[0], y - PISTON[1]


def pressure(rate, worn, x, y):
    """What wears by depth(rate, x, y) in a revolution, of a pad that has lost `worn`."""
    at = place(worn, x, y)
    return depth(rate, x, y) / (2.0 * math.pi * math.hypot(at[0], at[1]) * ALPHA * MU)


def rate(worn):
    """Wedge of a revolution, of a pad that has lost `worn`."""
    rows = [[0.0, 0.0, 0.0, right] for right in (FORCE, 0.0, 0.0)]
    arm = THICK - depth(worn, *PISTON)                       # of friction, about the piston on the back plate
    for X, Y in CELLS:
        x, y, to_x, to_y = place(worn, X, Y)
        r = math.hypot(x, y)
        for c, base in enumerate(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))):
            force = pressure(base, worn, X, Y) * AREA
            rows[0][c] += force
            rows[1][c] += force * (to_x - arm * MU * y / r)
            rows[2][c] += force * (to_y + arm * MU * x / r)
    return solved(rows)


def worn(revolutions, steps=50):
    """[(revolution, wedge lost)], steps of Heun's rule."""
    done, wedge, h = [(0.0, (0.0, 0.0, 0.0))], (0.0, 0.0, 0.0), revolutions / steps
    for n in range(steps):
        first = rate(wedge)
        second = rate([a + h * b for a, b in zip(wedge, first)])
        wedge = tuple(a + 0.5 * h * (b + c) for a, b, c in zip(wedge, first, second))
        done.append(((n + 1) * h, wedge))
    return done
