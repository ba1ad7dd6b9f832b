# Writes bed.data, exits.in, variables and about for deck.in; see dem/run.
# SPDX-License-Identifier: GPL-3.0-or-later

function emit(name, value) {
	printf " -var %s %.10g", name, value > "variables"
}

# LIGGGHTS wants every seed to be a prime above 10000.
function next_prime(    d) {
	for (seed += 2; ; seed += 2) {
		for (d = 3; d * d <= seed && seed % d != 0; d += 2)
			;
		if (d * d > seed)
			return seed
	}
}

# The bed: spheres at random places of a shell, a vertical face with a ledge
# of 45 degrees below, on which rock rests in a chamber of this kind.
function make_bed(r, d, top, ledge, reach,    n, z, a, at, step, row, i, count) {
	step = 0.8 * d
	for (row = 0; ; row++) {
		z = top - row * step
		at = z > 0 ? r : r + z
		if (z < -ledge)
			break
		n = int(2 * pi * at / step)
		for (i = 0; i < n; i++) {
			a = 2 * pi * (i + rand()) / n
			out = at + d / 2 + 0.4 * d * (rand() - 0.5)
			line[++count] = sprintf("%d 2 %g %g %.6f %.6f %.6f",
			    count, d, density, out * cos(a), out * sin(a),
			    z + 0.3 * d * (rand() - 0.5))
		}
	}
	printf "The bed\n\n%d atoms\n2 atom types\n\n", count > "bed.data"
	printf "%g %g xlo xhi\n%g %g ylo yhi\n", -reach, reach, -reach,
	    reach > "bed.data"
	printf "%g %g zlo zhi\n\nAtoms\n\n", -ledge - 0.06, top + 0.06 > "bed.data"
	for (i = 1; i <= count; i++)
		print line[i] > "bed.data"
}

# What leaves the rotor: as many streams as exits, each at the tip speed times
# throw, at an angle from the tangent.
function make_exits(    i, n, a, dx, dy, share, mm, r, list, mix, total, largest, wide) {
	n = split(sizes, list, " ")
	for (i = 1; i <= n; i++) {
		split(list[i], share, ":")
		mm = share[1]
		largest = mm > largest ? mm : largest
		total += share[2]
		printf "fix s%d all particletemplate/sphere %d atom_type 1 " \
		    "density constant %g radius constant %g\n",
		    i, next_prime(), density, mm / 2000 > "exits.in"
		mix = mix sprintf(" s%d %g", i, share[2] / 100)
	}
	if (total < 99.9 || total > 100.1) {
		print "dem/run: expected SIZES whose shares add up to 100, got " \
		    total > "/dev/stderr"
		exit 2
	}
	printf "fix mix all particledistribution/discrete %d %d%s\n",
	    next_prime(), n, mix > "exits.in"
	r = rotor / 2
	wide = 2.5 * largest / 1000
	for (i = 0; i < exits; i++) {
		a = 2 * pi * (i + 0.25) / exits
		dx = -cos(ang) * sin(a) + sin(ang) * cos(a)
		dy = cos(ang) * cos(a) + sin(ang) * sin(a)
		printf "region e%d sphere %.6f %.6f %.6f %.6f units box\n", i,
		    r * cos(a), r * sin(a), height / 2, wide > "exits.in"
		printf "fix f%d flying insert/rate/region seed %d " \
		    "distributiontemplate mix nparticles INF massrate %.6g " \
		    "insert_every %d overlapcheck yes vel constant %.6f %.6f 0.0 " \
		    "region e%d\n", i, next_prime(),
		    rate / 3.6 / exits, insert_every, v * throw * dx,
		    v * throw * dy, i > "exits.in"
		printf "unfix f%d\n", i > "stop.in"
	}
}

BEGIN {
	srand(20210111)
	seed = 15485863
	pi = atan2(0, -1)
	ang = angle * pi / 180
	height = 0.1
	n = split(sizes, list, " ")
	least = 1e9
	for (i = 1; i <= n; i++) {
		split(list[i], share, ":")
		least = share[1] < least ? share[1] : least
		most = share[1] > most ? share[1] : most
	}
	# Hertz: how long two of the finest touch, 2.87 (m^2 / (R E^2 v))^(1/5).
	d = least / 1000
	m = density * pi / 6 * d ^ 3 / 2
	modulus = young / (1 - 0.25 ^ 2) / 2
	contact = 2.87 * (m * m / (d / 4 * modulus ^ 2 * v)) ^ 0.2
	dt = contact / 40
	insert_every = int(2.5 * 2.5 * most / 1000 / v / dt) + 1
	make_exits()
	make_bed(chamber / 2, bed / 1000, height + 0.06, 0.08,
	    chamber / 2 + 2 * bed / 1000)
	emit("skin", most / 1000)
	emit("young", young)
	emit("restitution", restitution)
	emit("bed_restitution", bed_restitution)
	emit("friction", friction)
	emit("density", density)
	emit("dt", dt)
	emit("every", every)
	emit("sizes_every", int(0.0005 / dt) + 1)
	emit("report", int(time / dt / 20) + 1)
	emit("feed_steps", int(feed / dt))
	emit("rest_steps", int((time - feed) / dt))
	printf "rotor %g m, chamber %g m, sizes (mm:%%) %s, %g t/h, angle %g, " \
	    "throw %g, restitution %g and %g (bed of %g mm), friction %g, " \
	    "%g Pa, feed for %g of %g s", rotor, chamber, sizes, rate, angle, throw,
	    restitution, bed_restitution, bed, friction, young, feed, time > "about"
}
