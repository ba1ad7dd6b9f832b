/* Build-time only: prints the generated part of tipspeed(1).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include "cmd/manual.h"

int
main(void)
{
	manual_commands(stdout);
	return ferror(stdout) != 0;
}
