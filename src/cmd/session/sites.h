/* The loaded sites: adding, finding, dropping.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SITES_H
#define TIPSPEED_CMD_SESSION_SITES_H

#include "cmd/session/session.h"

/* Adds a site, which the session then owns, and makes it the one in use.  It
 * replaces a site that was read from the same file. */
void session_add(struct session *s, struct site *site);

/* Keeps a site until the session ends, without loading it; the session then
 * owns it. */
void session_keep_site(struct session *s, struct site *site);

/* Removes a site from those loaded, and discards a calibration of it. */
void session_drop(struct session *s, size_t index);

/* Replaces a loaded site with its mended version, which the session then owns.
 * What a calibration found on the former version is discarded, and then true is
 * returned; other parameters stay. */
bool session_mend(struct session *s, size_t index, struct site *site);

/* Replaces the site in use with one that has more runs, which the session then
 * owns; from [n_run]: see site_with_cuts.  Its parameters and its fit stay, as
 * found on the former numbers; the new runs are held out. */
void session_replace_site(
    struct session *s, struct site *site, const size_t *from);

/* Finds a loaded site by name without case and accents ("borlange"), by name
 * and top size ("gavle/4") or by key.  If several or none match, the error
 * lists the loaded sites. */
bool session_find(
    struct session *s, const char *name, size_t *index, struct error *error);

/* Adds a site that was read, which the session then owns; refuses it if its
 * digest differs from `digest`, hexadecimal digits or NULL. */
bool session_add_loaded(struct session *s, struct site *site,
    const char *digest, struct error *error);

#endif
