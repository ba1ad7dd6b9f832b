/* The page Data: the sheet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PAGE_DATA_H
#define TIPSPEED_UI_PAGE_DATA_H

#include "ui/pane.h"

extern const struct page_ops page_data;

#endif
