#!/usr/bin/env bash
# The macro of FreeCAD, without a screen: it adds a solid with rounded edges. Skipped without
# FreeCAD.
macro=$(realpath "$(dirname "$0")/../../tools/freecad/round_edges_smoothly.FCMacro")
for freecad in freecadcmd FreeCADCmd ""; do command -v "$freecad" >/dev/null && break; done
[ -n "$freecad" ] || exit 77
. "$(dirname "$0")/functions.sh"
[ -x "$(dirname "$(realpath "$program")")/geometric_continuity_cad" ] || { trap - EXIT && exit 77; }
export GEOMETRIC_CONTINUITY_PROGRAM=$program MACRO=$macro HOME=$PWD

cat >script.py <<'PYTHON'
import importlib.machinery, importlib.util, os, sys, traceback
try:
    import FreeCAD, Part
    loader = importlib.machinery.SourceFileLoader("macro", os.environ["MACRO"])
    macro = importlib.util.module_from_spec(importlib.util.spec_from_loader("macro", loader))
    loader.exec_module(macro)
    document = FreeCAD.newDocument("test")
    box = document.addObject("Part::Box", "Box")
    box.Length, box.Width, box.Height = 30, 20, 10
    box.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(1, 1, 3), 40))
    document.recompute()
    copy = macro.add_rounded(box, 1.5)
    assert copy.Label == "Box rounded" and len(document.Objects) == 2
    # what is cut off is less than the prisms of the edges
    assert copy.Shape.isValid() and copy.Shape.isClosed() and len(copy.Shape.Solids) == 1
    assert 6000 - 240 * 1.5 * 1.5 / 2 < copy.Shape.Volume < 6000 - 240 * 1.5 * 1.5 * 0.03, copy.Shape.Volume
    copy.Shape.exportBrep("box.brep")
    copy.Shape.exportStep("box.step") # with fewer digits
    def refusal(*arguments):
        try:
            macro.add_rounded(*arguments)
        except RuntimeError as error:
            return str(error)
        return "not refused"
    too_far = refusal(box, 6)
    assert "the set-back 6 must be less than 5" in too_far and "edge" in too_far, too_far
    one = macro.add_rounded(box, 1, [3]) # edge 2 of the program; it runs out at its faces
    assert one.Shape.isValid() and len(one.Shape.Faces) == 7 and copy.Shape.Volume < one.Shape.Volume < 6000, one.Shape.Volume
    document.removeObject(one.Name)
    cylinder = document.addObject("Part::Cylinder", "Cylinder")
    document.recompute()
    rim = macro.add_rounded(cylinder, 0.5)
    assert rim.Shape.isValid() and len(rim.Shape.Faces) == 5 and rim.Shape.Volume < cylinder.Shape.Volume, rim.Shape.Volume
    document.removeObject(rim.Name)
    document.removeObject(cylinder.Name)
    sphere = document.addObject("Part::Sphere", "Sphere")
    document.recompute()
    assert "sphere, neither a plane nor a wall" in refusal(sphere, 1), refusal(sphere, 1)
    assert len(document.Objects) == 3
    two = document.addObject("Part::Feature", "Two")
    two.Shape = Part.makeCompound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, FreeCAD.Vector(3, 0, 0))])
    assert refusal(two, 0.1) == "Two has 2 solids: select an object of one."
    os.environ["GEOMETRIC_CONTINUITY_PROGRAM"] = "/nowhere/program"
    assert "is not installed" in refusal(box, 1)
    print("all is well")
except BaseException:
    traceback.print_exc(file=sys.stdout)
sys.stdout.flush()
os._exit(0)
PYTHON
timeout 100 "$freecad" script.py >freecad.log 2>&1 </dev/null
says freecad.log "all is well"
for ending in brep step; do run 0 verify box.$ending --require G2 --within 1e-9,1e-5deg,0.1%; done
