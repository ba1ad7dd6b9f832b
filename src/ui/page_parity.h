/* The page Parity: predicted against measured.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PAGE_PARITY_H
#define TIPSPEED_UI_PAGE_PARITY_H

#include "ui/pane.h"

extern const struct page_ops page_parity;

#endif
