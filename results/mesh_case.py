"""What the studies over meshes have in common: closed forms' numbers, and words by which scenes of geo/ become others."""
import math

import contact_case as cc
from wear_case import profile_error, worn_profile

LOW_A, LOW_P0 = 0.2, 109.89011                        # references B1: p0 / E* = 1e-3
A, C, P0, MU = 0.0913360, 0.0645843, 836.410, 0.6     # B1b, B2 at Q = mu P / 2
A0 = 0.0358622                                        # B1a: half width of B8 and C1 before wear
SECOND = ('material = "steel"', 'material = "steel"\norder = 2')
ONLY_LOADING = [('[[step]]\nname = "unload"\nplay = ["unload"]\nincrements = 20\n', ""),
                ('[[step]]\nname = "reverse"\nplay = ["reverse"]\nincrements = 20\n', ""),
                ("every_increment = true", "every_cycles = 1"), ("increments = 10", "increments = 5")]
# line_contact_gross_slip to S = 1, in the same blocks on every mesh: what differs is the mesh alone
TO_ONE = [('\n[[step]]\nname = "to S = 10"\ncycles = 4500\njump = 100\n', ""), ("half_width_mm = 0.1", "half_width_mm = 0.065"),
          ("every_cycles = 500", "every_cycles = 1000")]
SAME_BLOCKS = [("jump = 1\n", "jump = 5\n"), ("jump = 10\n", "jump = 30\n")]


def traction_error(rows, pressure, shear, norm):
    """Of pressure and shear together, relative."""
    return math.hypot(cc.l2_error(cc.profile(rows, "pressure_MPa"), pressure), cc.l2_error(cc.profile(rows, "shear_MPa"), shear)) / norm


def mindlin_norm():
    """Of pressure and shear at the peak load."""
    return P0 * math.sqrt(4.0 * A / 3.0 + cc.l2_error([(-A, 0.0), (A, 0.0)], lambda x: cc.mindlin(x, A, C, MU), 4000) ** 2)


def wear_error(done, reference, frame=-1):
    """The larger side's, of the profile and of the largest depth."""
    errors = []
    for side in ("secondary", "primary"):
        found, exact = (worn_profile(r.frames(side)[frame][1]) for r in (done, reference))
        deepest = [max(w for _, w in profile) for profile in (found, exact)]
        errors += [profile_error(found, exact), abs(deepest[0] / deepest[1] - 1.0)]
    return max(errors)
