#!/usr/bin/python3
"""What the fluid is measured against: experiments and formulas, each with its source. Run by itself it
checks the formulas against quadrature and finite differences, and prints them for the drop of the plots."""

import csv
import math
import pathlib

import numpy

HERE = pathlib.Path(__file__).resolve().parent
INCH = 0.0254


def martin_moyce(n2, quantity):
    """Martin and Moyce 1952: the collapse of a column a = 2.25 inches wide and n²·a high, n2 1 or 2.
    quantity Z: the front, Z = x/a, at T = n·t·√(g/a); H: the height left at the wall, as a part of n²·a, at
    τ = t·√(g/a). Two arrays, of times and of values."""
    with open(HERE / "martin_moyce.csv", newline="") as text:
        rows = [r for r in csv.DictReader(text) if int(r["n2"]) == n2 and r["quantity"] == quantity]
    return (numpy.array([float(r["time"]) for r in rows]), numpy.array([float(r["value"]) for r in rows]))


def martin_moyce_times(n2, quantity, seconds, a=2.25 * INCH, gravity=9.81):
    """Seconds of a run in the units of martin_moyce."""
    return numpy.asarray(seconds) * math.sqrt(gravity / a) * (math.sqrt(n2) if quantity == "Z" else 1)


def ritter_front(height, time, gravity=9.81):
    """How far the front of a shallow dam break gets on a dry bed: 2·√(g·height)·t [Ritter 1892]. No column as
    narrow as it is high does: it bounds the front's speed from above."""
    return 2 * math.sqrt(gravity * height) * time


def fall_at_wall(n2, terms=20):
    """How fast the surface at the wall begins to fall, over g, when a column 1 wide and n2 high is let go: the
    pressure's series, Laplace's equation with 0 at the free sides and the weight at the foot."""
    waves = (numpy.arange(terms) + 0.5) * math.pi
    return 1 - float(numpy.sum(2 * (-1.0) ** numpy.arange(terms) / (waves * numpy.cosh(waves * n2))))


def vortex_decay(kinematic_viscosity):
    """The rate at which u = (sin x·cos y, −cos x·sin y) decays: 2ν [Taylor and Green 1937]; without viscosity it is
    steady."""
    return 2 * kinematic_viscosity


def bend_of_column(bend, slenderness, shorter):
    """The deflection of a viscous column between clamps that a plate has shortened by a part of its length: Euler's
    column, the load 3μ·area·(rate of shortening), 3μ for Young's modulus; slight, slender, of constant volume.
    d(ln bend) is 12/(2π)²·(height/width)²·d(ln height)."""
    return bend * math.exp(slenderness**2 / math.pi**2 * (1 - (1 - shorter) ** 3))


def drop_frequency(n, tension, density, radius):
    """ω of the nth mode of a drop without viscosity in vacuo: ω² = n(n−1)(n+2)σ/(ρR³) [Lamb 1932, §275]. To
    first order in the amplitude: of second order it falls."""
    return math.sqrt(n * (n - 1) * (n + 2) * tension / (density * radius**3))


def drop_decay(n, kinematic_viscosity, radius):
    """The rate at which the nth mode's amplitude decays where viscosity is small: (n−1)(2n+1)ν/R² [Lamb 1932,
    §355]."""
    return (n - 1) * (2 * n + 1) * kinematic_viscosity / radius**2


def shear_wave_decay(wavenumber, kinematic_viscosity):
    """The rate at which u = sin(ky) decays: νk²."""
    return kinematic_viscosity * wavenumber**2


def pressure_in_drop(tension, radius):
    """Young and Laplace: 2σ/R."""
    return 2 * tension / radius


def frequency_by_quadrature(n, tension, density, radius, nodes=200):
    """ω of drop_frequency again, from the energies of r = R(1 + ε·Pₙ) itself: half the second difference of the
    area at constant volume over the kinetic energy of the potential flow that moves the surface so."""
    x, weight = numpy.polynomial.legendre.leggauss(nodes)
    polynomial = numpy.polynomial.legendre.Legendre.basis(n)
    p, slope = polynomial(x), polynomial.deriv()(x)

    def area(epsilon):
        shape = 1 + epsilon * p
        shape = shape / (numpy.sum(weight * shape**3) / 2) ** (1 / 3)
        by_angle = shape * epsilon * slope * numpy.sqrt(1 - x * x) / (1 + epsilon * p)
        return 2 * math.pi * radius**2 * numpy.sum(weight * shape * numpy.sqrt(shape**2 + by_angle**2))

    step = 1e-3
    stiffness = tension * (area(step) - 2 * area(0) + area(-step)) / step**2
    # φ = R²·ε'·Pₙ·(r/R)ⁿ/n; the kinetic energy is half of ρ∮φ·∂φ/∂r.
    mass = density * 2 * math.pi * radius**5 / n * numpy.sum(weight * p * p)
    return math.sqrt(stiffness / mass)


def shear_decay_by_differences(wavenumber, kinematic_viscosity, points=400):
    """The rate of shear_wave_decay again, from ∂u/∂t = ν·∂²u/∂y² on one wavelength."""
    step = 2 * math.pi / wavenumber / points
    u = numpy.sin(wavenumber * step * numpy.arange(points))
    change = kinematic_viscosity * (numpy.roll(u, 1) - 2 * u + numpy.roll(u, -1)) / step**2
    return -float(numpy.dot(change, u) / numpy.dot(u, u))


def fall_by_differences(n2, cells=48):
    """fall_at_wall again, from Laplace's equation on nodes; the line above the top has the pressure's odd mirror."""
    h, rows, columns = 1 / cells, n2 * cells, cells
    matrix, right = numpy.zeros((rows * columns,) * 2), numpy.zeros(rows * columns)
    for j in range(rows):
        for i in range(columns):
            at = j * columns + i
            matrix[at, at] = -4
            for other_i, other_j in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
                if other_j < 0:
                    right[at] -= 2 * h  # the foot: dp/dy = −1
                    other_j = 1
                if 0 <= other_j < rows and other_i < columns:
                    matrix[at, other_j * columns + abs(other_i)] += 1
    pressure = numpy.linalg.solve(matrix, right)
    below = [pressure[(rows - n) * columns] for n in (1, 2)]
    return 1 - (4 * below[0] - below[1]) / (2 * h)


def check():
    for n2 in (1, 2):
        exact, found = fall_at_wall(n2), fall_by_differences(n2, 24)
        assert abs(found / exact - 1) < 2e-3, (n2, exact, found)
    for n in range(2, 7):
        exact, found = drop_frequency(n, 0.07, 1000, 0.01), frequency_by_quadrature(n, 0.07, 1000, 0.01)
        assert abs(found / exact - 1) < 1e-4, (n, exact, found)
    exact, found = shear_wave_decay(3, 0.2), shear_decay_by_differences(3, 0.2)
    assert abs(found / exact - 1) < 1e-4, (exact, found)
    for n2 in (1, 2):
        for quantity, sign in (("Z", 1), ("H", -1)):
            time, value = martin_moyce(n2, quantity)
            assert len(time) > 5 and (numpy.diff(time) > 0).all() and (sign * numpy.diff(value) > 0).all()
        time, front = martin_moyce(n2, "Z")  # in T Ritter's speed is 2 whatever n is
        assert (front - 1 < 2 * time).all()


def main():
    check()
    print("a drop with σ = 0.07, ρ = 1000, R = 0.01, ν = 1e-6:")
    print(f"  pressure in it {pressure_in_drop(0.07, 0.01):.4g}")
    for n in (2, 3, 4):
        omega = drop_frequency(n, 0.07, 1000, 0.01)
        print(f"  mode {n}: ω {omega:.5g}, period {2 * math.pi / omega:.5g}, decay {drop_decay(n, 1e-6, 0.01):.3g}")
    for n2 in (1, 2):
        time, front = martin_moyce(n2, "Z")
        late = numpy.polyfit(time[-8:], front[-8:], 1)[0]
        print(f"Martin and Moyce, n² = {n2}: dZ/dT of the last eight points {late:.3f}; Ritter 2")


if __name__ == "__main__":
    main()
