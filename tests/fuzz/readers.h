/* The readers of files, each fed with bytes from anywhere.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_READERS_H
#define TIPSPEED_TESTS_READERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* read: true where the bytes are what the reader wants. */
struct reader {
	const char *name;
	bool (*read)(const char *path);
};

/* By name; NULL where there is none. */
const struct reader *reader_find(const char *name);

/* Reads n bytes from a file in a folder that goes when the program ends. */
bool reader_feed(const struct reader *reader, const uint8_t *bytes, size_t n);

#endif
