/* The sites that come with the program.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FS_SHIPPED_H
#define TIPSPEED_IO_FS_SHIPPED_H

/* The folder they are in, with its "/": data/sites/ in the tree, or where the
 * program was installed.  It may be missing.  The caller frees. */
char *shipped_folder(void);

/* The file of a site by its name alone ("tierp", "Gävle 4"); NULL where the
 * name has a folder, or no site of it is shipped.  The caller frees. */
char *shipped_path(const char *name);

/* Likewise of collision energies ("vsi-69"). */
char *shipped_energies(const char *name);

#endif
