/* The loaded sites: adds, finds, replaces and drops them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SITES_H
#define TIPSPEED_CMD_SESSION_SITES_H

#include "cmd/session/session.h"

/* Adds a site, of which it takes ownership, and makes it the current one.  A
 * site from the same file is replaced. */
void session_add_site(struct session *s, struct site *site);

/* Takes ownership of a site until the session ends, without loading it. */
void session_take_ownership_of_site(struct session *s, struct site *site);

/* Unloads a site, and discards a paused calibration of it. */
void session_remove_site(struct session *s, size_t index);

/* Replaces the current site by its mended version, of which it takes ownership.
 * Returns true if parameters found by calibrating the former version were
 * discarded; other parameters are kept. */
bool session_replace_site_by_mended(struct session *s, struct site *site);

/* Replaces the current site by one with more runs, of which it takes ownership.
 * The parameters and the fit are kept, although they were found on fewer data;
 * the new runs are held out.  from [n_run]: see site_copy_with_cuts. */
void session_replace_site_by_extended(
    struct session *s, struct site *site, const size_t *from);

/* Finds a loaded site by its key, by name and top size ("gavle/4"), or by name,
 * ignoring case and accents ("borlange").  If no site or more than one matches,
 * the error lists the loaded sites. */
bool session_find_site(
    struct session *s, const char *name, size_t *index, struct error *error);

/* Adds a site, of which it takes ownership.  Returns false with an error unless
 * `digest`, in hexadecimal digits, is that of the site or NULL. */
bool session_add_site_if_same_digest(struct session *s, struct site *site,
    const char *digest, struct error *error);

#endif
