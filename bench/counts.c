/* counts NAME [N]: see counts.h and bench/README.md.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "counts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/fit/job.h"
#include "cmd/run/line.h"
#include "cmd/session/sites.h"

static const struct kind {
	const char *name;
	bool (*count)(size_t n);
	size_t n;
} KINDS[] = {
    {"advise", count_advise, 84},
    {"doctor", count_doctor, 140},
    {"drift", count_drift, 60},
    {"guess", count_guess, 360},
    {"league", count_league, 84},
    {"params", count_params, 100},
    {"power", count_power, 2000},
    {"speeds", count_speeds, 60},
    {"window", count_window, 280},
};

bool
counts_share(size_t inside, size_t n, double least, double most)
{
	double share = (double)inside / (double)n, all = (double)n;
	/* Computed as if one more were inside and one more outside, so that it
	 * is never 0. */
	double part = ((double)inside + 1) / (all + 2),
	       error = sqrt(part * (1 - part) / all);
	printf(" %3.0f +- %-3.1f", 100 * share, 100 * error);
	return share >= least - 3 * error && share <= most + 3 * error;
}

void
counts_add(struct counts_mean *mean, double value)
{
	if (isnan(value))
		return;
	mean->n++;
	mean->sum += value;
	mean->squares += value * value;
}

double
counts_error(const struct counts_mean *mean)
{
	double m = mean->sum / mean->n;
	double variance = mean->squares / mean->n - m * m;
	return sqrt(fmax(variance, 0) / fmax(mean->n - 1, 1));
}

void
counts_print(const struct counts_mean *mean, double scale)
{
	int digits = scale > 1 ? 0 : 2;
	printf(" %5.*f +- %-4.*f", digits, scale * mean->sum / mean->n,
	    digits + (scale > 1), scale * counts_error(mean));
}

bool
counts_between(const struct counts_mean *mean, double least, double most)
{
	/* As in counts_share, the error is never 0. */
	double m = mean->sum / mean->n,
	       error = fmax(counts_error(mean), 0.5 / mean->n);
	return mean->n == 0 ||
	       (m >= least - 3 * error && m <= most + 3 * error);
}

struct plant
counts_plant(size_t i, uint64_t *number)
{
	const uint64_t first = 501;
	*number = first + i / LAWS;
	return plant_of((enum law)(i % LAWS), *number);
}

struct counts_talk {
	struct session *session;
	FILE *out, *notes;
	char *text;
	size_t n;
};

struct counts_talk *
counts_talk(struct site *site)
{
	struct counts_talk *t = xcalloc(1, sizeof *t);
	free(site->name);
	site->name = xstrdup("plant");
	t->out = open_memstream(&t->text, &t->n);
	t->notes = fopen("/dev/null", "w");
	t->session = session_new(t->out, t->notes);
	session_add_site(t->session, site);
	counts_say(t, "set format json");
	return t;
}

void
counts_talk_end(struct counts_talk *t)
{
	session_free(t->session);
	fclose(t->out);
	fclose(t->notes);
	free(t->text);
	free(t);
}

const char *
counts_say(struct counts_talk *t, const char *line)
{
	struct error error = {0};
	size_t next = 0;
	rewind(t->out);
	if (!session_run_line(
		t->session, line, 0, "counts", 1, &next, &error)) {
		error_print(&error, stderr);
		exit(1);
	}
	while (session_is_calibrating(t->session))
		session_step_job(t->session);
	fputc('\0', t->out);
	fflush(t->out);
	return t->text;
}

double
counts_number(const char *json, const char *key)
{
	const char *at = strstr(json, key);
	double value = NAN;
	if (at != NULL && sscanf(at + strlen(key), "%lf", &value) != 1)
		value = NAN;
	return value;
}

struct fit
counts_fit(const struct site *site, const struct calibrate_options *options)
{
	struct calibration *c = calibration_new(site, options);
	while (calibration_step(c) <= CALIBRATE_POLISHING)
		;
	struct fit fit = calibration_best_fit(c);
	calibration_free(c);
	return fit;
}

struct posterior *
counts_calibrate(const struct site *site, uint64_t seed, struct fit *fit)
{
	bool *use = xcalloc(site->n_run, sizeof *use);
	for (size_t r = 0; r < site->n_run; r++)
		use[r] = true;
	struct calibrate_options o = calibrate_options_default();
	o.train = use;
	o.seed = seed;
	*fit = counts_fit(site, &o);
	struct posterior *p = posterior_new(site, &fit->params,
	    &(struct posterior_options){.use = use,
		.settings = fit->settings,
		.bounds = o.bounds,
		.seed = 1,
		.threads = 2,
		.isa = ISA_BEST});
	free(use);
	return p;
}

int
main(int argc, char **argv)
{
	for (size_t k = 0; argc > 1 && k < sizeof KINDS / sizeof *KINDS; k++)
		if (strcmp(argv[1], KINDS[k].name) == 0) {
			size_t n =
			    argc > 2 ? strtoul(argv[2], NULL, 10) : KINDS[k].n;
			bool ok = KINDS[k].count(n);
			printf("%s %s\n", ok ? "ok" : "not ok", argv[1]);
			return ok ? 0 : 1;
		}
	fprintf(stderr, "usage: counts KIND [N], KIND one of");
	for (size_t k = 0; k < sizeof KINDS / sizeof *KINDS; k++)
		fprintf(stderr, " %s", KINDS[k].name);
	fprintf(stderr, "\n");
	return 2;
}
