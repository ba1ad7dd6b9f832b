/* Sheets made by crossing habits at random are read rightly, asked about or
 * refused, and never read wrongly in silence.
 *
 * TIPSPEED_TEST_HABIT_SEED: one sheet alone, which is shown.
 * TIPSPEED_TEST_HABITS: how many sheets.
 * TIPSPEED_TEST_ENCODINGS=0: all in UTF-8.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "desk.h"
#include "habits.h"
#include "often.h"

enum verdict { RIGHT, ASKED, REFUSED, WRONG, N_VERDICT };
static const char *const VERDICTS[] = {"right", "asked", "refused", "wrong"};

/* Of a question: whether the command it proposes, as it stands, and the right
 * answer, in one step or two, load the truth. */
enum { PROPOSED_RIGHT, PROPOSED_WRONG, ANSWERED, ANSWERED_WRONG, N_SETTLED };

/* One sheet in ten is a trap; traps are counted apart. */
enum { A_TRAP_IN = 10 };

struct outcome {
	enum verdict verdict;
	bool settled[N_SETTLED];
	char text[512], hint[512], why[512];
};

struct tally {
	size_t verdict[2][N_VERDICT]; /* sheets, traps */
	size_t habit[MOST_HABITS][N_VERDICT];
	size_t trap[MOST_HABITS][N_VERDICT];
	size_t settled[N_SETTLED];
	size_t without_hint;
};

static char *
folder(void)
{
	return xasprintf("/tmp/tipspeed-habits-%ld", (long)getpid());
}

/* Removes what put_files wrote. */
static void
drop_files(const struct plan *plan, const char *path)
{
	for (size_t i = 0; i < plan->n_file; i++) {
		char *name = xasprintf("%s/%s", path, plan->file[i].name);
		unlink(name);
		free(name);
	}
	rmdir(path);
}

static void
put_file(const struct made_file *file, const char *name)
{
	if (file->n_sheet > 0) {
		sheets_save(file, name);
		return;
	}
	FILE *out = fopen(name, "wb");
	assert_non_null(out);
	assert_int_equal(fwrite(file->bytes, 1, file->n, out), file->n);
	assert_int_equal(fclose(out), 0);
}

/* Writes the files of a plan; adds their paths to the line. */
static void
put_files(const struct plan *plan, const char *path, char **line)
{
	assert_int_equal(mkdir(path, 0700), 0);
	for (size_t i = 0; i < plan->n_file; i++) {
		const struct made_file *file = &plan->file[i];
		char *name = xasprintf("%s/%s", path, file->name);
		xappend(line, " %s", name);
		if (file->at > 0)
			xappend(line, "@%g", file->at);
		put_file(file, name);
		free(name);
	}
}

/* By how much a size may differ: names are of openings that are not theirs
 * times 25.4, and decimal inches are rounded. */
static double
near_size(const struct plan *plan, const struct curve *want)
{
	if (plan->sizes == SIZE_INCHES)
		return 0.016;
	return want->sieve[want->n - 1]->name != NULL ? 0.012 : 0.009;
}

/* A curve of a site against the truth; NULL, or what is wrong. */
static char *
curve_differs(const struct curve *want, const struct psd *got, double near)
{
	size_t found = 0;
	for (size_t i = 0; i < want->n; i++) {
		double mm = want->mm[i];
		size_t k = 0;
		while (
		    k < got->n && !(fabs(got->size[k] * 1000 / mm - 1) <= near))
			k++;
		if (k == got->n && (want->left_out[i] || want->maybe[i]))
			continue;
		if (k == got->n)
			return xasprintf("there is no sieve of %g mm", mm);
		found++;
		double pct = 100 * got->passing[k];
		if (isnan(want->pct[i]))
			return xasprintf(
			    "%g %% at %g mm, which is empty", pct, mm);
		if (!(fabs(pct - want->pct[i]) <= want->slack))
			return xasprintf("%g %% at %g mm, not %g to %g", pct,
			    mm, want->pct[i], want->slack);
	}
	return found == got->n
		   ? NULL
		   : xasprintf("%zu sieves, not %zu", got->n, found);
}

/* Products in the order of the runs: by speed, repeats by their place. */
static size_t
product_order(const struct plan *plan, size_t *order)
{
	size_t n = 0;
	for (size_t i = 0; i < plan->n_curve; i++) {
		const struct curve *c = &plan->curve[i];
		if (c->feed)
			continue;
		size_t at = n++;
		for (; at > 0; at--) {
			const struct curve *o = &plan->curve[order[at - 1]];
			if (o->speed < c->speed - 1e-6 ||
			    (o->speed < c->speed + 1e-6 &&
				plan->curve_column[order[at - 1]] <=
				    plan->curve_column[i]))
				break;
			order[at] = order[at - 1];
		}
		order[at] = i;
	}
	return n;
}

static char *
site_differs(const struct plan *plan, const struct site *site)
{
	size_t order[MOST_CURVES], n = product_order(plan, order);
	char *why = NULL;
	if (plan->trap != NULL && plan->n_curve == 0)
		return xstrdup("there is no such site");
	const struct curve *feed = &plan->curve[0];
	size_t products = site_count_products(site);
	if (products != n || site->n_run < 1)
		return xasprintf("%zu runs, not %zu", products, n);
	if (n == 0)
		return curve_differs(
		    feed, &site->run[0].feed, near_size(plan, feed));
	for (size_t i = 0; i < n && why == NULL; i++) {
		const struct curve *want = &plan->curve[order[i]];
		const struct run *run = &site->run[i];
		if (plan->individual)
			feed = &plan->curve[order[i] - 1];
		if (!(fabs(run->speed - want->speed) <= 0.06))
			return xasprintf(
			    "%g m/s, not %g", run->speed, want->speed);
		char *what =
		    curve_differs(want, &run->product, near_size(plan, want));
		if (what != NULL)
			why = xasprintf("product at %g: %s", run->speed, what);
		else if (feed->feed && (what = curve_differs(feed, &run->feed,
					    near_size(plan, feed))) != NULL)
			why = xasprintf("feed at %g: %s", run->speed, what);
		free(what);
	}
	return why;
}

/* NULL where all that was loaded is the truth. */
static char *
differs(const struct plan *plan, const struct session *s)
{
	size_t wanted = plan->other != NULL ? 2 : 1;
	bool trap = plan->trap != NULL;
	for (size_t i = 0; trap && i < traps_count(); i++)
		if (strcmp(TRAPS[i].name, plan->trap) == 0 && TRAPS[i].nothing)
			return xstrdup("it cannot be known");
	if (s->n_entry != wanted)
		return xasprintf("%zu sites, not %zu", s->n_entry, wanted);
	char *why = site_differs(plan, s->entry[0].site);
	if (why == NULL && wanted == 2)
		why = site_differs(plan->other, s->entry[1].site);
	return why;
}

static bool
asks(const struct error *e)
{
	static const char *const WAYS[] = {
	    "columns=", "decimal=", "rotor_mm=", "sheet=", "range="};
	for (size_t i = 0; i < ARRAY_LEN(WAYS); i++)
		if (strstr(e->hint, WAYS[i]) != NULL ||
		    strstr(e->text, WAYS[i]) != NULL)
			return true;
	return false;
}

/* What columns= should say, of a sheet with one table. */
static char *
right_columns(const struct plan *plan)
{
	static const char *const UNITS[] = {"passing_pct", "fraction",
	    "retained_g", "retained_pct", "retained_fraction",
	    "cum_retained_pct", "cum_retained_g", "cum_retained_fraction"};
	const char *size = plan->sizes == SIZE_UM       ? "um"
			   : plan->sizes == SIZE_INCHES ? "in"
							: "mm";
	if (plan->size_column == 0)
		return NULL;
	char *text =
	    xasprintf("columns=\"%zu=sieve %s", plan->size_column, size);
	for (size_t i = 0; i < plan->n_curve; i++) {
		const struct curve *c = &plan->curve[i];
		xappend(&text, ", %zu=%s", plan->curve_column[i],
		    c->feed ? "feed" : "product");
		if (c->speed > 0)
			xappend(&text, "@%.4g", c->speed);
		xappend(&text, " %s", UNITS[c->quantity]);
	}
	xappend(&text, "\"");
	return text;
}

/* The right answer to a question, added to the line; false where it is none of
 * those that a test can answer, as one of two sites is asked about. */
static bool
answer_to(const struct plan *plan, const struct error *e, char **line)
{
	if (plan->other != NULL)
		return false;
	bool roles = strstr(e->hint, "columns=") != NULL;
	char *columns = roles ? right_columns(plan) : NULL;
	if (strstr(e->hint, "rotor_mm=") != NULL)
		xappend(line, " rotor_mm=%g", plan->rotor_mm);
	else if (strstr(e->hint, "decimal=") != NULL)
		xappend(line, " decimal=%s",
		    plan->decimal == ',' ? "comma" : "point");
	else if (columns != NULL)
		xappend(line, " %s", columns);
	else
		return false;
	free(columns);
	return true;
}

/* What a line loads: 1 the truth, 0 something else, -1 nothing. */
static int
loads(const struct plan *plan, const char *line, struct error *error)
{
	void *state = NULL;
	desk_open(&state);
	struct desk *desk = state;
	bool loaded = desk_say(desk, line);
	char *why = loaded ? differs(plan, desk->session) : NULL;
	*error = desk->error;
	desk_close(&state);
	int result = !loaded ? -1 : why == NULL;
	if (why != NULL)
		snprintf(error->text, sizeof error->text, "%s", why);
	free(why);
	return result;
}

/* The command that a hint proposes, as it stands: from "load " to the end of
 * the line, or of the quotes that it began in. */
static char *
proposed(const char *hint)
{
	const char *at = strstr(hint, "load ");
	if (at == NULL)
		return NULL;
	size_t n = strcspn(at, "\n");
	if (at > hint && at[-1] == '\'') {
		const char *quote = strchr(at, '\'');
		n = quote != NULL ? (size_t)(quote - at) : n;
	}
	return xstrndup(at, n);
}

static void
settle_at_stationary_point(const struct plan *plan, const char *line,
    const struct error *question, struct outcome *o)
{
	struct error error = *question;
	char *command = proposed(error.hint), *answered = xstrdup(line);
	int result = command != NULL ? loads(plan, command, &error) : -1;
	o->settled[PROPOSED_RIGHT] = result == 1;
	o->settled[PROPOSED_WRONG] = result == 0;
	error = *question;
	result = -1;
	for (int step = 0; step < 3 && result < 0; step++) {
		if (!answer_to(plan, &error, &answered))
			break;
		result = loads(plan, answered, &error);
	}
	o->settled[ANSWERED] = result == 1;
	o->settled[ANSWERED_WRONG] = result == 0;
	free(command);
	free(answered);
}

static void
show(const struct plan *plan, const char *line, const struct outcome *o)
{
	char *habits = plan_habits(plan);
	printf("# seed %llu: %s\n# habits: %s\n# %s\n# %s\n# %s | %s\n",
	    (unsigned long long)plan->seed, VERDICTS[o->verdict], habits, line,
	    o->why, o->text, o->hint);
	for (size_t i = 0; i < plan->n_file; i++) {
		const struct made_file *f = &plan->file[i];
		printf("# --- %s\n", f->name);
		char last = '\n';
		for (size_t k = 0; k < f->n && k < 6000; k++) {
			char c = f->bytes[k] == '\r' ? '\n' : f->bytes[k];
			if (c == '\0' || (c == '\n' && last == '\n'))
				continue;
			printf(last == '\n' ? "#| %c" : "%c", c);
			last = c;
		}
	}
	printf("# ---\n");
	free(habits);
}

static struct outcome
try_plan(const struct plan *plan, const char *path, bool shown)
{
	struct outcome o = {.verdict = RIGHT};
	struct error error;
	char *line = xstrdup("load"), *second = xasprintf("%s/other", path);
	put_files(plan, path, &line);
	if (plan->other != NULL)
		put_files(plan->other, second, &line);
	int result = loads(plan, line, &error);
	if (result == 0)
		snprintf(o.why, sizeof o.why, "%s", error.text);
	snprintf(o.text, sizeof o.text, "%s", error.text);
	snprintf(o.hint, sizeof o.hint, "%s", error.hint);
	o.verdict = result == 1    ? RIGHT
		    : result == 0  ? WRONG
		    : asks(&error) ? ASKED
				   : REFUSED;
	if (o.verdict == ASKED)
		settle_at_stationary_point(plan, line, &error, &o);
	if (o.verdict == WRONG || shown)
		show(plan, line, &o);
	if (plan->other != NULL)
		drop_files(plan->other, second);
	drop_files(plan, path);
	free(line);
	free(second);
	return o;
}

static void
count(struct tally *t, const struct plan *plan, const struct outcome *o)
{
	bool trap = plan->trap != NULL;
	t->verdict[trap][o->verdict]++;
	for (size_t i = 0; trap && i < traps_count(); i++)
		if (strcmp(TRAPS[i].name, plan->trap) == 0)
			t->trap[i][o->verdict]++;
	for (size_t i = 0; !trap && i < habits_count(); i++)
		if (plan->used[i])
			t->habit[i][o->verdict]++;
	/* Of a trap no answer is right. */
	for (size_t i = 0; i < N_SETTLED && !trap; i++)
		t->settled[i] += o->settled[i];
	t->without_hint += o->verdict == REFUSED && o->hint[0] == '\0';
}

static void
print_counts(const char *name, const size_t *count)
{
	printf("# %-38s", name);
	for (size_t v = 0; v < N_VERDICT; v++)
		printf(" %5zu %s", count[v], VERDICTS[v]);
	putchar('\n');
}

static void
print_tally(const struct tally *t)
{
	for (size_t i = 0; i < habits_count(); i++)
		print_counts(HABITS[i].name, t->habit[i]);
	for (size_t i = 0; i < traps_count(); i++)
		print_counts(TRAPS[i].name, t->trap[i]);
	print_counts("ALL SHEETS", t->verdict[0]);
	print_counts("ALL TRAPS", t->verdict[1]);
	printf("# of the questions: %zu settled by the command proposed, %zu "
	       "settled wrongly by it; %zu settled by the right answer, %zu "
	       "not\n",
	    t->settled[PROPOSED_RIGHT], t->settled[PROPOSED_WRONG],
	    t->settled[ANSWERED], t->settled[ANSWERED_WRONG]);
}

static struct plan *
plan_of(uint64_t seed)
{
	bool trap = seed % A_TRAP_IN == 0;
	return plan_new(
	    seed, trap ? (int)(seed / A_TRAP_IN % traps_count()) : -1);
}

static uint64_t
from_environment(const char *name, uint64_t otherwise)
{
	const char *text = getenv(name);
	return text != NULL && *text != '\0' ? strtoull(text, NULL, 10)
					     : otherwise;
}

static void
no_sheet_is_read_wrongly(void **state)
{
	(void)state;
	struct tally tally = {0};
	char *path = folder();
	uint64_t one = from_environment("TIPSPEED_TEST_HABIT_SEED", 0);
	uint64_t n = from_environment("TIPSPEED_TEST_HABITS", often(400, 2000));
	for (uint64_t seed = one > 0 ? one : 1;
	     seed <= (one > 0 ? one : n * A_TRAP_IN / (A_TRAP_IN - 1));
	     seed++) {
		struct plan *plan = plan_of(seed);
		struct outcome o = try_plan(plan, path, one > 0);
		if (o.verdict == REFUSED && getenv("TIPSPEED_TEST_REFUSED"))
			printf("# refused %llu: %s | %s\n",
			    (unsigned long long)seed, o.text, o.hint);
		if (o.verdict == ASKED && getenv("TIPSPEED_TEST_REFUSED"))
			printf("# asked %llu: proposal %s, answer %s: %s | "
			       "%s\n",
			    (unsigned long long)seed,
			    o.settled[PROPOSED_RIGHT]   ? "right"
			    : o.settled[PROPOSED_WRONG] ? "wrong"
							: "none",
			    o.settled[ANSWERED]         ? "right"
			    : o.settled[ANSWERED_WRONG] ? "wrong"
							: "none",
			    o.text, o.hint);
		count(&tally, plan, &o);
		plan_free(plan);
	}
	free(path);
	print_tally(&tally);
	size_t sheets = 0;
	for (size_t v = 0; v < N_VERDICT; v++)
		sheets += tally.verdict[0][v];
	assert_int_equal(tally.verdict[0][WRONG] + tally.verdict[1][WRONG], 0);
	assert_int_equal(tally.settled[ANSWERED_WRONG], 0);
	assert_int_equal(tally.without_hint, 0);
	assert_true(10 * tally.verdict[0][RIGHT] >= 9 * sheets || one > 0);
}

/* The truth of a plan as the program writes a site: of this the reader and the
 * comparison are sure. */
static char *
strict_sheet(struct plan *plan)
{
	double mm[2 * MOST_SIEVES];
	size_t n = 0;
	char *text = xstrdup("size_mm"), number[32];
	for (size_t c = 0; c < plan->n_curve; c++)
		for (size_t i = 0; i < plan->curve[c].n; i++) {
			double v = plan->curve[c].mm[i];
			size_t at = 0;
			while (at < n && mm[at] > v)
				at++;
			if (at < n && mm[at] == v)
				continue;
			memmove(&mm[at + 1], &mm[at], (n - at) * sizeof *mm);
			mm[at] = v;
			n++;
		}
	for (size_t c = 0; c < plan->n_curve; c++) {
		plan->curve_column[c] = c + 1;
		xappend(&text, ",%s%s%s",
		    plan->curve[c].feed ? "feed" : "product",
		    plan->curve[c].speed > 0 ? "@" : "",
		    plan->curve[c].speed > 0 ? text_shortest_exact_number(
						   plan->curve[c].speed, number)
					     : "");
	}
	for (size_t k = 0; k < n; k++) {
		xappend(
		    &text, "\n%s", text_shortest_exact_number(mm[k], number));
		for (size_t c = 0; c < plan->n_curve; c++) {
			const struct curve *curve = &plan->curve[c];
			size_t i = 0;
			while (i < curve->n && curve->mm[i] != mm[k])
				i++;
			xappend(&text, ",%s",
			    i < curve->n && !isnan(curve->pct[i])
				? text_shortest_exact_number(
				      curve->pct[i], number)
				: "");
		}
	}
	xappend(&text, "\n");
	return text;
}

static void
the_truth_is_told_by_a_strict_sheet(void **state)
{
	(void)state;
	char *path = folder();
	bool one = getenv("TIPSPEED_TEST_HABIT_SEED") != NULL;
	size_t n = 0;
	for (uint64_t seed = 1; n < 50 && !one; seed++) {
		struct plan *plan = plan_new(seed, -1);
		size_t products = 0;
		for (size_t c = 0; c < plan->n_curve; c++)
			products += !plan->curve[c].feed;
		if (plan->other == NULL && products > 1) {
			char *line = xstrdup("load"),
			     *text = strict_sheet(plan);
			struct error error;
			for (size_t i = 0; i < plan->n_file; i++)
				file_clear(&plan->file[i]);
			plan->n_file = 0;
			plan->coding = UTF_8;
			plan_text(plan, "strict.csv", text);
			put_files(plan, path, &line);
			if (loads(plan, line, &error) != 1)
				fail_msg("seed %llu: %s\n%s",
				    (unsigned long long)seed, error.text, text);
			drop_files(plan, path);
			free(line);
			free(text);
			n++;
		}
		plan_free(plan);
	}
	free(path);
}

int
main(void)
{
	setvbuf(stdout, NULL, _IOLBF, 0);
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(the_truth_is_told_by_a_strict_sheet),
	    cmocka_unit_test(no_sheet_is_read_wrongly),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
