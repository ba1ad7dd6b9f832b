/* The page Sites: what each loaded site is and how far it is calibrated.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PAGE_SITES_H
#define TIPSPEED_UI_PAGE_SITES_H

#include "ui/pane.h"

extern const struct page_ops page_sites;

#endif
