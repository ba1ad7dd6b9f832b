/* The files that come with the program.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FS_SHIPPED_H
#define TIPSPEED_IO_FS_SHIPPED_H

/* Returns the folder of the sites, with a final "/": data/sites/ in the source
 * tree, or the installed folder, which may not exist.  The caller frees it. */
char *shipped_sites_folder(void);

/* Returns the file of a site from its bare name ("tierp", "Gävle 4"), or NULL
 * if the name contains a folder or no such site is shipped.  The caller frees
 * it. */
char *shipped_site_path(const char *name);

/* As shipped_site_path, for a file of collision energies ("vsi-69"). */
char *shipped_energies_path(const char *name);

/* Returns the file that examples call data/NAME, or NULL if path is not of that
 * form or no such file is shipped.  The caller frees it. */
char *shipped_example_path(const char *path);

#endif
