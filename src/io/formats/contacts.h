/* Contacts of a simulation, in snapshots, merged into impacts of particles.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_CONTACTS_H
#define TIPSPEED_IO_FORMATS_CONTACTS_H

#include <stdint.h>

#include "core/model/spectrum.h"

enum { CONTACTS_ID_MOST = 20000000 };

/* Finds the impacts of a dump, see collisions_read.  Impacts are added to the
 * spectrum; the contacts of a snapshot and the particles are kept. */
struct contacts;

/* cut: J/kg; an impact below it does not count as a particle's first.  density:
 * kg/m3. */
struct contacts *contacts_new(struct spectrum *to, double cut, double density);
void contacts_free(struct contacts *c);

/* Sets the radius of a particle, m. */
void contacts_particle(struct contacts *c, uint32_t id, double radius);

/* Adds a contact to the snapshot.  x, v [6]: positions (m) and velocities
 * (m/s). */
void contacts_add(struct contacts *c, uint32_t id1, uint32_t id2,
    const double *x, const double *v);

/* Begins the next snapshot: a contact that is not in the last one has ended. */
void contacts_end_snapshot(struct contacts *c);

/* Ends the last snapshot, counts the particles and returns the number of
 * impacts. */
uint64_t contacts_end(struct contacts *c);

#endif
