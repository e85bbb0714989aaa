"""Whether two placed polyhedra collide, exactly.

>>> import numpy as np, tetracone
>>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
>>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
>>> cube = tetracone.Body(vertices, faces)
>>> poses = np.tile(np.eye(3, 4), (3, 1, 1))
>>> poses[:, 0, 3] = [0.5, 1, np.nextafter(1, 2)]
>>> tetracone.Query(cube, cube).collide(poses)
array([ True,  True, False])

`Body` and `read` make bodies. `Body.inside` says where points are, `Body.first_hit` and `Body.hits` where rays meet it.
`Query` asks about two bodies: `collide`, `relation`, `features`, `contacts` and more. `Scene` finds the pairs of many
bodies that collide. `kernels` and `methods` list the names that a query takes. A wrong value raises `Error`, an
argument of a wrong type Python's TypeError.
`tetracone.verify` has cases that are hard, their true answers, and the means to judge other libraries by them.
"""

from ._tetracone import Body, Contacts, Error, Query, Scene, __version__, kernels, methods, read

for _of_module in (Body, Contacts, Error, Query, Scene, read):
    _of_module.__module__ = "tetracone"
del _of_module

__all__ = ["Body", "Contacts", "Error", "Query", "Scene", "kernels", "methods", "read"]
