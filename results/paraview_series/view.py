"""Opens a run's series in ParaView, reports what it finds and draws four times of it.

  xvfb-run -a pvbatch view.py RUN_FOLDER   writes paraview.txt and series.png into the working folder
"""
import pathlib
import sys

from PIL import Image
from paraview import servermanager, simple

WINDOW = (1200, 800)
MIDDLE, HALF_HEIGHT = (0.0, 0.25), 2.6   # what is shown, in mm
COLOURS = [(1.0, 1.0, 0.98, 0.88), (4.0, 0.99, 0.85, 0.55), (15.0, 0.98, 0.6, 0.3), (55.0, 0.85, 0.25, 0.2),
           (200.0, 0.5, 0.0, 0.15)]      # MPa, then red, green, blue
BLACK = [0.0, 0.0, 0.0]


def arrays_of(data):
    """One line for each array: name, components, as ParaView names them."""
    found = []
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        names = [array.GetComponentName(c) for c in range(array.GetNumberOfComponents())]
        found.append(array.Name + (f" ({', '.join(map(str, names))})" if len(names) > 1 else ""))
    return found


def told(name, source, worn):
    """Lines on every time of one collection."""
    lines, first = [f"{name}: {len(source.TimestepValues)} times", "  time        points  cells  " + worn], None
    for time in source.TimestepValues:
        source.UpdatePipeline(time)
        info = source.GetDataInformation()
        arrays = ["points: " + a for a in arrays_of(source.PointData)] + ["cells: " + a for a in arrays_of(source.CellData)]
        first = first or arrays
        low, high = source.PointData[worn].GetRange(0)
        lines.append(f"  {time:<10g} {info.GetNumberOfPoints():>7} {info.GetNumberOfCells():>6}  {low:.6g} to {high:.6g}"
                     + ("" if arrays == first else "   other arrays: " + ", ".join(arrays)))
    return lines + ["  arrays at every time, except where noted:"] + ["    " + a for a in first]


def colours_of_stress():
    """Few colours over a logarithmic range: the contact spreads, and its stress falls by a factor of a hundred."""
    colours = simple.GetColorTransferFunction("von_mises")
    colours.RGBPoints = [x for point in COLOURS for x in point]
    colours.UseLogScale = 1
    colours.NumberOfTableValues = 16
    return colours


def add_bar(view, shown):
    bar = simple.GetScalarBar(simple.GetColorTransferFunction("von_mises"), view)
    bar.Title, bar.ComponentTitle = "von Mises, MPa", ""
    bar.TitleColor = bar.LabelColor = BLACK
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = "%.0f"
    bar.Orientation, bar.ScalarBarLength, bar.WindowLocation = "Horizontal", 0.5, "Lower Right Corner"
    bar.UseCustomLabels, bar.CustomLabels = 1, [1.0, 5.0, 20.0, 50.0, 200.0]
    bar.AddRangeLabels = 0
    shown.SetScalarBarVisibility(view, True)


def drawn(source, time):
    """A view of one time: elements coloured by von Mises stress."""
    view = simple.CreateView("RenderView")
    view.ViewTime = time
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.InteractionMode = "2D"
    view.CameraParallelProjection = 1
    view.CameraPosition, view.CameraFocalPoint = [*MIDDLE, 20.0], [*MIDDLE, 0.0]
    view.CameraParallelScale = HALF_HEIGHT
    shown = simple.Show(source, view)
    shown.Representation = "Surface With Edges"
    shown.EdgeColor = [0.45, 0.45, 0.5]
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    simple.ColorBy(shown, ("POINTS", "von_mises"))
    shown.LookupTable = colours_of_stress()
    label = simple.Show(simple.Text(Text=f"cycle {time:.0f}"), view)
    label.Color = BLACK
    label.WindowLocation = "Upper Center"
    return view


def picture(source, name):
    """Loaded and unworn, then early, at about a third and at the end of the run."""
    times = source.TimestepValues
    chosen = [times[1]] + [min(times[2:], key=lambda t: abs(t - share * times[-1])) for share in (0.05, 0.3, 1.0)]
    layout = simple.CreateLayout("times")
    layout.SplitHorizontal(0, 0.5)   # cell i becomes the cells 2i + 1 and 2i + 2
    layout.SplitVertical(1, 0.5)
    layout.SplitVertical(2, 0.5)
    for time, cell in zip(chosen, (3, 5, 4, 6)):
        view = drawn(source, time)
        layout.AssignView(cell, view)
    add_bar(view, simple.GetDisplayProperties(source, view))
    layout.SetSize(*WINDOW)
    simple.SaveScreenshot(name, layout, ImageResolution=WINDOW, TransparentBackground=0)
    Image.open(name).quantize(64).save(name, optimize=True)


def main(folder):
    series, surfaces = (simple.PVDReader(FileName=str(pathlib.Path(folder) / file)) for file in ("series.pvd", "surfaces.pvd"))
    lines = [servermanager.vtkSMProxyManager.GetParaViewSourceVersion()]
    for name, source in (("series.pvd", series), ("surfaces.pvd", surfaces)):
        lines += ["", *told(name, source, "wear_depth_mm")]
    pathlib.Path("paraview.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
    picture(series, "series.png")


if __name__ == "__main__":
    main(sys.argv[1])
