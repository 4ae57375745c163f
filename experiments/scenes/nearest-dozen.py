#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes nearest-dozen.csv: thirteen stars near the Sun as points in linear motion.

Source of the values: astrometry and radial velocities as published in Gaia DR2/DR3, Hipparcos (2007)
and, for Scholz's star, Mamajek et al. 2015 / Gaia DR2, rounded: right ascension (h, m, s), declination
(sign, deg, min, sec), parallax (mas), proper motion in right ascension (with cos dec) and declination
(mas/yr), radial velocity (km/s). Positions in parsec (equatorial, Sun at the origin), velocities in
parsec per million years, six decimals.

    /usr/bin/python3 nearest-dozen.py > nearest-dozen.csv
"""
from math import cos, radians, sin

STARS = [
    ("Proxima Cen", (14, 29, 42.95), ("-", 62, 40, 46.2), 768.07, -3781.7, 769.5, -22.2),
    ("Alpha Cen A", (14, 39, 36.49), ("-", 60, 50, 2.4), 750.81, -3679.3, 473.7, -21.4),
    ("Barnard's Star", (17, 57, 48.50), ("+", 4, 41, 36.1), 546.98, -801.6, 10362.4, -110.1),
    ("Wolf 359", (10, 56, 28.92), ("+", 7, 0, 53.0), 415.18, -3866.3, -2699.2, 19.3),
    ("Lalande 21185", (11, 3, 20.19), ("+", 35, 58, 11.6), 392.75, -580.1, -4776.6, -84.7),
    ("Sirius", (6, 45, 8.92), ("-", 16, 42, 58.0), 379.21, -546.0, -1223.1, -5.5),
    ("Ross 154", (18, 49, 49.36), ("-", 23, 50, 10.4), 336.03, 639.4, -194.0, -10.7),
    ("Ross 248", (23, 41, 55.04), ("+", 44, 10, 38.8), 316.48, 112.5, -1591.7, -77.3),
    ("Epsilon Eri", (3, 32, 55.84), ("-", 9, 27, 29.7), 310.58, -974.8, 20.9, 16.4),
    ("Lacaille 9352", (23, 5, 52.04), ("-", 35, 51, 11.1), 304.14, 6766.0, 1330.3, 8.8),
    ("Ross 128", (11, 47, 44.40), ("+", 0, 48, 16.4), 296.31, 607.3, -1223.0, -31.1),
    ("GJ 445", (11, 47, 41.38), ("+", 78, 41, 28.2), 190.33, 748.1, 480.8, -111.7),
    ("Scholz's Star", (7, 20, 3.25), ("-", 8, 46, 51.2), 147.1, -40.3, -114.8, 83.1),
]
KM_S_IN_PC_MYR = 1.0227121650537
KM_S_PER_AU_YEAR = 4.740470463


def row(name, ra, dec, parallax, pm_ra, pm_dec, radial):
    a = radians(15 * (ra[0] + ra[1] / 60 + ra[2] / 3600))
    d = radians(dec[1] + dec[2] / 60 + dec[3] / 3600) * (-1 if dec[0] == "-" else 1)
    distance = 1000 / parallax
    east, north = (KM_S_PER_AU_YEAR * pm / parallax for pm in (pm_ra, pm_dec))
    outward = (cos(d) * cos(a), cos(d) * sin(a), sin(d))
    eastward = (-sin(a), cos(a), 0.0)
    northward = (-sin(d) * cos(a), -sin(d) * sin(a), cos(d))
    position = [distance * u for u in outward]
    velocity = [
        KM_S_IN_PC_MYR * (radial * u + east * e + north * n)
        for u, e, n in zip(outward, eastward, northward)
    ]
    return name + "," + ",".join(f"{v:.6f}" for v in position + velocity)


print("id,x,y,z,vx,vy,vz")
for star in STARS:
    print(row(*star))
