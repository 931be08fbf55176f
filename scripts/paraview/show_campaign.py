"""Shows what `millwear export --paraview FOLDER` wrote: the liner coloured by its wear depth, the
particles as spheres coloured by their speed.

    pvpython scripts/paraview/show_campaign.py FOLDER                      # makes FOLDER/campaign.pvsm
    pvpython scripts/paraview/show_campaign.py FOLDER --cycle 2            # the frames of one cycle
    pvpython scripts/paraview/show_campaign.py FOLDER --picture mill.png   # a picture of the last time

`paraview FOLDER/campaign.pvsm` opens the state with everything set.
"""
import argparse
import os
import sys

from paraview.simple import *  # the way of ParaView's own scripts

CELLS, POINTS = "CELLS", "POINTS"


def open_series(folder, name):
    """The .pvd file as a source; none where the export has no such file."""
    path = os.path.abspath(os.path.join(folder, name + ".pvd"))
    if not os.path.exists(path):
        return None
    return OpenDataFile(path, registrationName=name)


def colour(display, view, association, array, title, where):
    ColorBy(display, (association, array))
    display.RescaleTransferFunctionToDataRangeOverTime()
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(GetColorTransferFunction(array), view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.WindowLocation = where


def show_liner(liner, view):
    display = Show(liner, view)
    colour(display, view, CELLS, "wear_depth_m", "wear depth, m", "Lower Left Corner")


def show_charge(charge, view):
    spheres = Glyph(Input=charge, GlyphType="Sphere", registrationName="particles")
    spheres.GlyphMode = "All Points"
    spheres.GlyphType.Radius = 0.5
    spheres.ScaleArray = [POINTS, "diameter_m"]
    spheres.ScaleFactor = 1.0
    spheres.OrientationArray = [POINTS, "No orientation array"]
    display = Show(spheres, view)
    colour(display, view, POINTS, "speed_m_per_s", "speed, m/s", "Lower Right Corner")


def show_time(liner, view, text):
    time = AnnotateTimeFilter(Input=liner, Format=text, registrationName="time")
    Show(time, view, "TextSourceRepresentation")


def look_into_the_mill(view):
    """As sections are drawn, x to the right and z up, and a little from above and from the right."""
    view.CameraPosition = [0.3, -1.0, 0.25]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    ResetCamera(view)


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("folder", help="what --paraview named")
    parser.add_argument("--cycle", type=int, help="the frames of this cycle, in place of the whole life")
    parser.add_argument("--picture", help="PNG to be written, in place of the state")
    parser.add_argument("--time", type=float, help="of the picture: hours, or seconds with --cycle; "
                        "by default the last")
    return parser.parse_args()


def main():
    asked = options()
    of_cycle = "" if asked.cycle is None else f"_cycle_{asked.cycle:03}"
    liner = open_series(asked.folder, "liner" + of_cycle)
    charge = open_series(asked.folder, "charge" + of_cycle)
    if liner is None:
        sys.exit(f"{asked.folder}: there is no liner{of_cycle}.pvd; `millwear export CASE --paraview "
                 f"{asked.folder}` writes it")
    view = GetActiveViewOrCreate("RenderView")
    view.ViewSize = [1200, 900]
    show_liner(liner, view)
    if charge is not None:
        show_charge(charge, view)
    show_time(liner, view, "{time:.0f} h" if asked.cycle is None else "{time:.3f} s")
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    view.ViewTime = max(liner.TimestepValues) if asked.time is None else asked.time
    scene.AnimationTime = view.ViewTime
    look_into_the_mill(view)
    if asked.picture:
        SaveScreenshot(asked.picture, view)
    else:
        SaveState(os.path.join(asked.folder, "campaign.pvsm"))


main()
