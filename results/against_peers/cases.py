"""The three cases of the comparison, as scenes of Reye and as values for the peers' decks."""
E_MPA, NU = 200e3, 0.3
HERTZ = {"a": 0.0913360, "p0": 836.410, "P": 120.0}                                    # references B1b
MINDLIN = dict(HERTZ, friction=0.6, Q=36.0, c=0.0645843, increments=10)                # B2
FRETTING = {"a": 0.0358622, "p0": 328.409, "P": 18.5, "friction": 0.9,                 # B1a, C1
            "stroke": 0.025, "increments": 40}
WEAR = {"flat": 3.2222222222e-5, "cylinder": 2.1111111111e-5}                          # mm^3/J, C1

HEAD = """title    = "{title}"
analysis = "plane_strain"
geometry = ["{mesh}"]

[material.steel]
E_MPa = 200e3
nu    = 0.3

[body.cylinder]
material = "steel"

[body.flat]
material = "steel"

[support.holder]
edge     = "top"
rotation = "fixed"
x        = {sideways}
y        = {{ force_N_per_mm = {force}, history = "press" }}

[support.base]
edge     = "bottom"
x        = {base}
y        = "fixed"
rotation = "fixed"

[history]
press  = [[0.0, 0.0], [1.0, 1.0]]
load   = [[0.0, 0.0], [1.0, 1.0]]
stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]

[output]
frames = {{ every_increment = {every}, paraview = false }}

[[step]]
name = "press"
play = ["press"]
wear = false
"""
FLAT_CARRIES = '\n[contact.pad]\nsecondary = "face"\nprimary   = ["round"]\n'
CYLINDER_CARRIES = '\n[contact.pad]\nsecondary = "round"\nprimary   = ["face"]\n'


def head(title, mesh, force, sideways='"fixed"', base='"fixed"', every="false"):
    return HEAD.format(title=title, mesh=mesh, force=-force, sideways=sideways, base=base, every=every)


def hertz(mesh):
    return head("Hertz", mesh, HERTZ["P"]) + FLAT_CARRIES


def mindlin(mesh):
    c = MINDLIN
    return (head("Cattaneo-Mindlin", mesh, c["P"], f'{{ force_N_per_mm = {c["Q"]}, history = "load" }}')
            + f'\n[[step]]\nname = "load"\nplay = ["load"]\nincrements = {c["increments"]}\n'
            + FLAT_CARRIES + f'friction  = {c["friction"]}\n')


def fretting(mesh, cycles=0):
    """Gross slip. cycles = 0: one stroke without wear, every increment written; else so many cycles with wear, shape
    moved, each a block. The cylinder carries the tractions: contact does not travel along it."""
    c = FRETTING
    play = f'\n[[step]]\nname = "cycle"\nplay = ["stroke"]\nincrements = {c["increments"]}\n'
    play += f"cycles = {cycles}\njump = 1\n" if cycles else "wear = false\n"
    wear = (f'wear = {{ law = "energy", secondary_mm3_per_J = {WEAR["cylinder"]}, '
            f'primary_mm3_per_J = {WEAR["flat"]} }}\n')
    return (head("Gross slip", mesh, c["P"], base=f'{{ motion_mm = {c["stroke"]}, history = "stroke" }}',
                 every="false" if cycles else "true") + play
            + CYLINDER_CARRIES + f'friction  = {c["friction"]}\n' + (wear if cycles else ""))
