/* Merges the contacts of snapshots into impacts: one that goes on from snapshot
 * to snapshot counts once, at its largest velocity.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/contacts.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

/* A contact as far as it is known: v, m/s, the largest relative normal
 * velocity. */
struct contact {
	uint32_t id1, id2; /* id1 0: the place is free */
	float v;
	bool fixed1, fixed2, kept; /* kept: the next snapshot has it too */
};

/* Open addressing; a power of two, at most half full. */
struct table {
	size_t n, room;
	struct contact *at;
};

/* radius: 0 where it is not known. */
struct particle {
	float radius;
	bool seen, hit;
};

struct contacts {
	struct spectrum *to;
	double cut, density;
	size_t n_particle;
	struct particle *particle; /* by id */
	struct table now, before;
	uint64_t impacts;
	bool sized; /* some radius is known */
};

struct contacts *
contacts_new(struct spectrum *to, double cut, double density)
{
	struct contacts *c = xcalloc(1, sizeof *c);
	*c = (struct contacts){.to = to, .cut = cut, .density = density};
	return c;
}

void
contacts_free(struct contacts *c)
{
	if (c == NULL)
		return;
	free(c->particle);
	free(c->now.at);
	free(c->before.at);
	free(c);
}

static struct particle *
particle_at(struct contacts *c, uint32_t id)
{
	if (id >= c->n_particle) {
		size_t n = 2 * c->n_particle + 64;
		n = n > id ? n : (size_t)id + 1;
		c->particle = xrealloc(c->particle, n, sizeof *c->particle);
		memset(c->particle + c->n_particle, 0,
		    (n - c->n_particle) * sizeof *c->particle);
		c->n_particle = n;
	}
	return &c->particle[id];
}

void
contacts_particle(struct contacts *c, uint32_t id, double radius)
{
	struct particle *p = particle_at(c, id);
	p->radius = (float)radius;
	p->seen = true;
	c->sized = true;
}

/* The place of a contact, or the free one for it; NULL in an empty table. */
static struct contact *
contacts_find(const struct table *t, uint32_t id1, uint32_t id2)
{
	if (t->room == 0)
		return NULL;
	uint64_t h = (((uint64_t)id1 << 32) | id2) * 0x9E3779B97F4A7C15u;
	size_t i = (size_t)(h >> 32) & (t->room - 1);
	while (
	    t->at[i].id1 != 0 && (t->at[i].id1 != id1 || t->at[i].id2 != id2))
		i = (i + 1) & (t->room - 1);
	return &t->at[i];
}

static void
contacts_grow(struct table *t)
{
	struct table wide = {.room = t->room > 0 ? 2 * t->room : 256};
	wide.at = xcalloc(wide.room, sizeof *wide.at);
	for (size_t i = 0; i < t->room; i++)
		if (t->at[i].id1 != 0)
			*contacts_find(&wide, t->at[i].id1, t->at[i].id2) =
			    t->at[i];
	wide.n = t->n;
	free(t->at);
	*t = wide;
}

/* Relative velocity along the line of the centres. */
static double
normal_velocity(const double *x, const double *v)
{
	double along = 0, length = 0;
	for (size_t i = 0; i < 3; i++) {
		double d = x[3 + i] - x[i];
		along += (v[i] - v[3 + i]) * d;
		length += d * d;
	}
	return length > 0 ? fabs(along) / sqrt(length) : 0;
}

static bool
is_at_rest(const double *v)
{
	return !(v[0] < 0 || v[0] > 0 || v[1] < 0 || v[1] > 0 || v[2] < 0 ||
		 v[2] > 0);
}

void
contacts_add(struct contacts *c, uint32_t id1, uint32_t id2, const double *x,
    const double *v)
{
	bool swap = id1 > id2;
	uint32_t low = swap ? id2 : id1, high = swap ? id1 : id2;
	bool fixed1 = is_at_rest(swap ? v + 3 : v);
	bool fixed2 = is_at_rest(swap ? v : v + 3);
	double vn = normal_velocity(x, v);
	if (2 * (c->now.n + 1) > c->now.room)
		contacts_grow(&c->now);
	struct contact *to = contacts_find(&c->now, low, high);
	struct contact *was = contacts_find(&c->before, low, high);
	c->now.n += to->id1 == 0;
	if (was != NULL && was->id1 != 0) {
		was->kept = true;
		vn = fmax(vn, (double)was->v);
		/* Who ever moved is no part of the bed. */
		fixed1 = fixed1 && was->fixed1;
		fixed2 = fixed2 && was->fixed2;
	}
	vn = fmax(vn, (double)to->v);
	*to = (struct contact){.id1 = low,
	    .id2 = high,
	    .v = (float)vn,
	    .fixed1 = fixed1,
	    .fixed2 = fixed2};
}

static double
mass_of(const struct contacts *c, const struct particle *p)
{
	const double ball = 4.18879020478639;
	double r = (double)p->radius;
	return c->sized ? c->density * ball * r * r * r : 1;
}

/* What an impact is to one of the two; one without a size, where others have
 * one, is not counted: its mass is not known. */
static void
add_impact_of_particle(struct contacts *c, uint32_t id, uint32_t other,
    bool fixed, const struct contact *contact)
{
	struct particle *p = particle_at(c, id);
	if (c->sized && !(p->radius > 0))
		return;
	double v = (double)contact->v, m = mass_of(c, p), e = v * v / 2;
	if (!fixed) {
		double M = mass_of(c, particle_at(c, other));
		e = M / (m + M) * v * v / 4;
	}
	p = particle_at(c, id);
	bool first = !p->hit && e >= c->cut;
	p->hit = p->hit || first;
	p->seen = true;
	spectrum_add_impact(c->to, 2 * (double)p->radius, m, e, first);
	c->impacts++;
}

static void
contact_ended(struct contacts *c, const struct contact *of)
{
	if (!of->fixed1)
		add_impact_of_particle(c, of->id1, of->id2, of->fixed2, of);
	if (!of->fixed2)
		add_impact_of_particle(c, of->id2, of->id1, of->fixed1, of);
}

void
contacts_end_snapshot(struct contacts *c)
{
	for (size_t i = 0; i < c->before.room; i++)
		if (c->before.at[i].id1 != 0 && !c->before.at[i].kept)
			contact_ended(c, &c->before.at[i]);
	struct table empty = c->before;
	if (empty.n > 0)
		memset(empty.at, 0, empty.room * sizeof *empty.at);
	empty.n = 0;
	c->before = c->now;
	c->now = empty;
}

uint64_t
contacts_end(struct contacts *c)
{
	contacts_end_snapshot(c);
	contacts_end_snapshot(c);
	for (size_t id = 0; id < c->n_particle; id++) {
		const struct particle *p = &c->particle[id];
		if (p->seen)
			spectrum_add_particles(
			    c->to, 2 * (double)p->radius, 1, mass_of(c, p));
	}
	c->to->counted = true;
	c->to->ordered = true;
	return c->impacts;
}
