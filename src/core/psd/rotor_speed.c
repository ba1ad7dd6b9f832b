/* Formats rotor speeds for sentences.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/rotor_speed.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"

char *
rotor_speed_rpm_text(double diameter, double low, double high)
{
	if (!(diameter > 0))
		return xstrdup("");
	double slow = rotor_speed_to_rpm(low, diameter);
	return isnan(high) ? xasprintf(tr(" (%.0f rpm)"), slow)
			   : xasprintf(tr(" (%.0f to %.0f rpm)"), slow,
				 rotor_speed_to_rpm(high, diameter));
}
