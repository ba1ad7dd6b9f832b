/* Materials: the parameters of a breakage model, and where they come from.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_MATERIAL_H
#define TIPSPEED_IO_STORE_MATERIAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "core/model/breakage.h"

/* One material.  Texts are never NULL, but "" if not known; an unknown number
 * is NAN, an unknown whole number -1.  feed_source: for a row of Table 3, its
 * feeds, such as "Individual"; else NULL.  provenance: that of the site's data,
 * so that synthetic data are never mistaken for measured data.  origin: "fit",
 * "hand" or, for Table 3, "table3".  rmse_pct: in percentage points, on the
 * training runs; holdout_pct: the largest of the other runs.  basis: see
 * basis.h. */
struct material {
	char *name, *site, *rock, *machine, *provenance, *site_digest;
	char *origin, *method, *appearance, *options, *stop, *train_mps;
	char *date, *note, *version, *basis, *feed_source;
	double top_size_mm, k, misfit, rmse_pct, holdout_pct;
	struct params params;
	int64_t seed, generations;
};

struct material_list {
	size_t n;
	struct material *item;
};

/* What kind of value a field has.  FIELD_MODEL: the name of the breakage model;
 * FIELD_PARAMS: all its parameters, "beta1=0 .. alpha=0.96". */
enum field_kind {
	FIELD_TEXT,
	FIELD_NUMBER,
	FIELD_WHOLE,
	FIELD_MODEL,
	FIELD_PARAMS
};

/* A column of the store and of its CSV form.  needed: it is never empty.
 * choices: the allowed texts, or NULL; least, most: the limits of a number. */
struct field {
	const char *name;
	enum field_kind kind;
	size_t offset;
	bool needed;
	const char *choices;
	double least, most;
};

enum { FIELD_COUNT = 25, FIELD_OF_NAME = 0 };
extern const struct field FIELDS[FIELD_COUNT];

/* Returns a material in which no field is known. */
struct material material_make_empty(void);
void material_free(struct material *m);
void material_list_free(struct material_list *list);

/* Moves m to the end of the list. */
void material_list_add(struct material_list *list, struct material m);

/* Returns the material with this name, ignoring case and accents, or NULL. */
const struct material *material_find(
    const struct material_list *list, const char *name);

/* Return the place of a field's value in m, by the kind of the field. */
char **material_text_field_pointer(
    const struct material *m, const struct field *f);
double *material_number_field_pointer(
    const struct material *m, const struct field *f);
int64_t *material_integer_field_pointer(
    const struct material *m, const struct field *f);
/* Returns a field of any kind as a text that reads back as the same value, or
 * "" if not known.  The caller frees it. */
char *material_field_to_text(const struct material *m, const struct field *f);

/* Sets a field from a text as material_field_to_text returns it.  The model is
 * set before the parameters.  Numbers that cannot be read become unknown, and
 * parameters NAN, which material_is_field_valid rejects. */
void material_set_field(
    struct material *m, const struct field *f, const char *text);

/* Calls take for each known field and parameter of m, in the order of
 * FIELDS. */
typedef void material_take_field(
    void *data, const char *name, const char *text);
void material_visit_fields(
    const struct material *m, material_take_field *take, void *data);

/* Returns a digest of all known fields of m, with which the store detects rows
 * damaged on disk. */
uint64_t material_compute_digest(const struct material *m);

/* Returns the material's method, appearance and k as settings. */
struct model_settings material_model_settings(const struct material *m);

/* These check imports and rows of a file, which may come from other users.
 * material_valid_values_text describes the valid values of a field, "a number
 * from 0 to 100 for alpha"; for the parameters, those of the first invalid one
 * in m.  material_faulty_value_text returns the value in m.  The caller frees
 * both.  material_is_field_valid is true if the value in m is valid. */
char *material_valid_values_text(
    const struct material *m, const struct field *f);
char *material_faulty_value_text(
    const struct material *m, const struct field *f);
bool material_is_field_valid(const struct material *m, const struct field *f);

/* Returns true if a name is one line of 1 to 60 bytes without double quotes,
 * does not begin with # and is not a name from Table 3 ("table3/..."); else
 * false with a usage error. */
bool material_check_name(const char *name, struct error *error);

/* True for the rows of Table 3, which cannot be changed, and for their
 * names. */
bool material_is_table3(const struct material *m);
bool material_is_table3_name(const char *name);

/* True if a text is one line of UTF-8 without control characters. */
bool material_is_text_printable(const char *text);

/* Adds the rows of a file such as data/table3.csv, whose columns are rock,
 * site, top_size_mm, f_mat, feed_source, E0_min and alpha, in this order.
 * beta, which the table does not have, gets its default.  On failure, returns
 * false and adds all faults of the sheet to errors, which the caller has
 * zeroed; ERROR_SYSTEM if the file cannot be read. */
bool material_read_table3_file(
    const char *path, struct material_list *list, struct error_list *errors);

/* Adds the built-in rows of Table 3, named "table3/tierp", "table3/gavle/11.2",
 * "table3/gavle/11.2/2". */
void material_add_table3_to_list(struct material_list *list);

#endif
