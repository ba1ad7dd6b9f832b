/* The page Fit: the search, generation by generation, while it runs and after.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PAGE_FIT_H
#define TIPSPEED_UI_PAGE_FIT_H

#include "ui/pane.h"

extern const struct page_ops page_fit;

#endif
