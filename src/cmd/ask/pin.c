/* A pin holds the prediction itself, so it does not change when the site is
 * calibrated again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/pin.h"

#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/question.h"
#include "cmd/ask/forecast.h"
#include "cmd/lang/table.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/units.h"

void
pin_free(struct pin *pin)
{
	prediction_free(&pin->p);
	free(pin->key);
	free(pin);
}

static bool
unpin_prediction(struct session *s, const char *word, struct error *error)
{
	if (strcmp(word, "off") != 0)
		return error_set(error, ERROR_USAGE,
		    "pin: expected options or off, got '%s'\n"
		    "write: pin speed=74",
		    word);
	s->pin = NULL;
	return true;
}

/* While a calibration runs, pins a prediction of the best parameters so far. */
static bool
pin_prediction(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	const struct entry *entry = q->entry;
	struct params params = entry->params;
	bool forming = answers_best_params_so_far(s, entry, &params);
	if (!forming && !answers_require_params_current_site(s, error))
		return false;
	if (q->scenario.feed != NULL)
		return error_set(error, ERROR_USAGE,
		    "pin: expected a feed that was sampled at the site, got "
		    "%s\n"
		    "write: pin speed=74 feed=mean",
		    q->entry->site->feed_from);
	question_use_last_speed_and_feed(s, args, q);
	struct question whole = question_of_whole_product(s, entry, q->feed);
	whole.params = &params;
	struct pin *pin = xcalloc(1, sizeof *pin);
	*pin = (struct pin){.site = entry->site,
	    .key = xstrdup(entry->key),
	    .p = forecast_product(s, &whole, q->speed)};
	s->pins = xrealloc(s->pins, s->n_pin + 1, sizeof(*s->pins));
	s->pin = s->pins[s->n_pin++] = pin;
	FREED char *rpm =
	    rotor_speed_rpm_text(entry->site->rotor, q->speed, NAN);
	session_print_note(s,
	    forming
		? N_("pinned %s at %.*f m/s%s, from the running calibration: "
		     "save leaves it out")
		: N_("pinned %s at %.*f m/s%s"),
	    pin->key, units_speed_decimals(q->speed), q->speed, rpm);
	return true;
}

bool
cmd_pin(struct session *s, const struct args *args, struct error *error)
{
	return args->n_operand > 0
		   ? unpin_prediction(s, args->operand[0], error)
		   : session_require_site(s, "pin", error) &&
			 question_read_and_answer(
			     s, args, pin_prediction, error);
}
