# YADE's time per DEM step for a packing CSV, in simple shear on one core, with the physics of the reference files.
# Run by yade_ratio.sh: yade -n -x -j1 tests/bench/yade_step.py PACKING.csv STEPS
import sys
import time
from math import radians

from yade import O
from yade.wrapper import *
import yade.utils as utils
from yade.minieigenHP import Matrix3, Vector3

packing, steps = sys.argv[1], int(sys.argv[2])
depth, young, density = 0.1, 800e6, 2650.0
rows, cell = [], None
for line in open(packing):
    if line.startswith("#"):
        words = line[1:].split()
        if len(words) == 4 and words[0][0].isdigit():
            cell = [float(w) for w in words]
    elif line[0].isdigit():
        rows.append([float(w) for w in line.split(",")])

O.periodic = True
O.cell.hSize = Matrix3(cell[0], cell[1], 0, cell[2], cell[3], 0, 0, 0, depth)
material = CohFrictMat(young=young, poisson=0.5, frictionAngle=radians(23), density=density, isCohesive=False,
                       momentRotationLaw=True, alphaKr=1.0, alphaKtw=0.0, etaRoll=0.05, normalCohesion=0,
                       shearCohesion=0)
O.materials.append(material)
for _, x, y, r in rows:
    body = utils.sphere((x, y, 0.5 * depth), r, material=material)
    body.state.blockedDOFs = "zXY"
    mass = density * depth * 3.141592653589793 * r * r
    body.state.mass = mass
    body.state.inertia = Vector3(1, 1, 1) * 0.5 * mass * r * r
    O.bodies.append(body)
O.cell.velGrad = Matrix3(0, 0.4, 0, 0, 0, 0, 0, 0, 0)
O.cell.homoDeform = 2
O.dt = 1e-5
law = Law2_ScGeom6D_CohFrictPhys_CohesionMoment(useIncrementalForm=True, always_use_moment_law=True)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=-0.1, allowBiggerThanPeriod=True),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D(avoidGranularRatcheting=True)], [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys()], [law]),
    NewtonIntegrator(damping=0.1),
]
O.run(steps // 10, True)
start = time.process_time()
O.run(steps, True)
seconds = time.process_time() - start
contacts = sum(1 for i in O.interactions if i.isReal)
print("us_per_step %.3f contacts %d" % (1e6 * seconds / steps, contacts))
