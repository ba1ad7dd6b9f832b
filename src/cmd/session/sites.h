/* The loaded sites: adding, finding, dropping.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SITES_H
#define TIPSPEED_CMD_SESSION_SITES_H

#include "cmd/session/session.h"

/* Adds a site, takes ownership of it and makes it the current one.  It replaces
 * a site read from the same file. */
void session_add_site(struct session *s, struct site *site);

/* Takes ownership of a site until the session ends, without loading it. */
void session_adopt_unloaded_site(struct session *s, struct site *site);

/* Unloads a site and discards a calibration of it. */
void session_drop_site(struct session *s, size_t index);

/* Replaces a loaded site with its mended version and takes ownership of that.
 * If calibration results for the former version are discarded, returns true;
 * other parameters are kept. */
bool session_replace_by_mended(
    struct session *s, size_t index, struct site *site);

/* Replaces the current site with one that has more runs and takes ownership of
 * that.  Keeps the parameters and the fit, which were found on the former data;
 * the new runs are held out.  from [n_run]: see site_copy_with_cuts. */
void session_replace_by_extended(
    struct session *s, struct site *site, const size_t *from);

/* Finds a loaded site by name, ignoring case and accents ("borlange"), by name
 * and top size ("gavle/4") or by key.  If several or none match, the error
 * lists the loaded sites. */
bool session_find_site(
    struct session *s, const char *name, size_t *index, struct error *error);

/* Adds a site that was read and takes ownership of it; rejects it if its digest
 * differs from `digest`, hexadecimal digits or NULL. */
bool session_add_if_digest_matches(struct session *s, struct site *site,
    const char *digest, struct error *error);

#endif
