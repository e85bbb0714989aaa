#!/usr/bin/python3
"""A subject around VTK (Debian: python3-vtk9): vtkCollisionDetectionFilter, surfaces under rigid motions, points of double."""

import json
import os
import sys
import time

from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersModeling import vtkCollisionDetectionFilter

replies = os.fdopen(os.dup(1), "w")  # VTK's messages go to standard error
os.dup2(2, 1)


def poly_data(model):
    """The body's triangles, or fans from an old harness; nothing where a face has a hole."""
    triangles = model.get("triangles")
    if triangles is None:
        if any(len(loops) > 1 for loops in model["faces"]):
            return None
        triangles = [[f[0], f[k - 1], f[k]] for f, in model["faces"] for k in range(2, len(f))]
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for v in model["vertices"]:
        points.InsertNextPoint(v)
    cells = vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(3, triangle)
    body = vtkPolyData()
    body.SetPoints(points)
    body.SetPolys(cells)
    return body


def matrix(pose):
    m = vtkMatrix4x4()
    for k, entry in enumerate(pose):
        m.SetElement(k // 4, k % 4, float(entry))
    return m


def answer(message):
    told = {"ask": message["ask"], "answer": None}
    a, b = bodies[message["a"]], bodies[message["b"]]
    poses = message["pose_a"], message["pose_b"]
    if message["question"] != "surface" or not a or not b or any(isinstance(x, str) for pose in poses for x in pose):
        return told
    check = vtkCollisionDetectionFilter()
    for k, (body, pose) in enumerate(zip((a, b), poses)):
        check.SetInputData(k, body)
        check.SetMatrix(k, matrix(pose))
    check.SetCollisionModeToFirstContact()
    start = time.perf_counter_ns()
    check.Update()
    return told | {"answer": int(check.GetNumberOfContacts() > 0), "ns": time.perf_counter_ns() - start}


hello = {"hello": 1, "name": "VTK", "version": vtkVersion.GetVTKVersion(), "precision": "float64", "bodies": "any", "poses": "rigid",
         "questions": ["surface"], "touching": "closed"}
print(json.dumps(hello), file=replies, flush=True)
bodies = {}
for line in sys.stdin:
    message = json.loads(line)
    if "model" in message:
        bodies[message["model"]] = poly_data(message)
    bodies.pop(message.get("forget"), None)
    if "ask" in message:
        print(json.dumps(answer(message)), file=replies, flush=True)
