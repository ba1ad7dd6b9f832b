/* map: plots e0_min against f_mat for Table 3, the store and the loaded sites,
 * with a series for each rock.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots.h"

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/draw/site_chart.h"
#include "core/model/breakage.h"

/* If there are more materials than this, their names are not drawn. */
enum { MOST_NAMED = 60 };

/* Adds the point of a material; takes ownership of the strings. */
static void
add_material_point(struct chart_series *series, const struct params *p,
    char *name, char *label, char *about)
{
	size_t i = series->n++;
	series->x[i] = params_value_by_name(p, "f_mat");
	series->y[i] = params_value_by_name(p, "e0_min");
	series->whose[i] = (struct chart_whose){name, about, label};
}

static struct chart_series *
add_empty_material_series(struct chart *chart, struct chart_series look,
    size_t most, bool named, const char *name)
{
	struct chart_series *series =
	    chart_append_series(chart, look, most, "%s", name);
	chart_allocate_point_names(series);
	series->named = named;
	series->n = 0;
	return series;
}

/* Adds the materials of one rock as a series of their own. */
static void
add_material_series_of_rock(
    struct chart *chart, const struct material_list *list, const char *rock)
{
	struct chart_series look = site_chart_series_style(chart->n);
	look.line = CHART_MARKS;
	struct chart_series *series = add_empty_material_series(chart, look,
	    list->n, list->n <= MOST_NAMED,
	    rock[0] != '\0' ? rock : tr("not stated"));
	for (size_t i = 0; i < list->n; i++) {
		const struct material *m = &list->item[i];
		if (text_is_same_folded(m->rock, rock))
			add_material_point(series, &m->params, xstrdup(m->name),
			    xstrdup(m->site), xstrdup(m->provenance));
	}
}

/* True for the first material of its rock in the list. */
static bool
is_first_material_of_rock(const struct material_list *list, size_t at)
{
	for (size_t i = 0; i < at; i++)
		if (text_is_same_folded(
			list->item[i].rock, list->item[at].rock))
			return false;
	return true;
}

static bool
has_parameter_on_bound(const struct entry *entry)
{
	size_t n = entry->has_fit
		       ? breakage_model_of_params(&entry->fit.params)->n
		       : 0;
	bool any = false;
	for (size_t j = 0; j < n; j++)
		any = any || entry->fit.on_bound[j];
	return any;
}

/* Adds the loaded sites that have parameters: those with a parameter at its
 * bound or, unless `bound`, the others. */
static void
add_loaded_sites_to_param_map(
    struct chart *chart, const struct session *s, bool bound)
{
	struct chart_series *series = NULL;
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *entry = &s->entry[i];
		if (!entry->has_params ||
		    has_parameter_on_bound(entry) != bound)
			continue;
		if (series == NULL)
			series = add_empty_material_series(chart,
			    (struct chart_series){.series = SERIES_PREDICTED,
				.mark = bound ? 'X' : '#'},
			    s->n_entry, s->n_entry <= MOST_NAMED,
			    bound ? tr("loaded, a parameter at its bound")
				  : tr("loaded sites"));
		add_material_point(series, &entry->params, xstrdup(entry->key),
		    xstrdup(entry->site->name),
		    site_provenance_first_clause(entry->site, ""));
	}
}

/* Lists the materials of the store and of Table 3.  From a large store it takes
 * only every *apart-th material, so that at most MOST are drawn. */
static bool
list_every_nth_material(const struct session *s, struct material_list *list,
    size_t *apart, struct error *error)
{
	enum { MOST = 1000 };
	size_t n;
	if (!store_count_materials(s->store, &n, error))
		return false;
	*apart = 1 + (n > 0 ? (n - 1) / MOST : 0);
	const struct store_query query = {.apart = *apart};
	bool ok = store_find_materials(s->store, &query, list, error);
	material_add_table3_to_list(list);
	return ok;
}

/* Returns the sources of the data on the map.  The caller frees them. */
static char *
material_map_sources_text(const struct session *s, size_t apart)
{
	char number[32];
	struct sources all = {0};
	char *about =
	    apart > 1 ? xasprintf(tr("Table 3 of Grunditz et al. (2021) and "
				     "the user's own fits, one shown of each "
				     "%s"),
			    text_shortest_exact_number((double)apart, number))
		      : xstrdup(tr("Table 3 of Grunditz et al. (2021) and the "
				   "user's own fits"));
	for (size_t i = 0; i < s->n_entry; i++)
		if (s->entry[i].has_params)
			sources_add_site(
			    &all, s->entry[i].key, s->entry[i].site);
	FREED char *loaded = sources_text_and_clear(&all);
	if (loaded[0] != '\0')
		xappend_to_list(&about, "; ", tr("loaded sites: %s"), loaded);
	return about;
}

/* Draws the paper's figure 10: f_mat and e0_min of the materials of the store
 * and of Table 3, by rock, and of all loaded sites that have parameters.  A fit
 * with a parameter at its bound is marked. */
struct chart *
plots_material_map(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct material_list list = {0};
	size_t apart;
	(void)q;
	if (!list_every_nth_material(s, &list, &apart, error))
		return NULL;
	FREED char *about = material_map_sources_text(s, apart);
	struct chart *chart = chart_new(
	    tr("materials by rock"), about, (struct axis){0}, (struct axis){0});
	for (size_t i = 0; i < list.n; i++)
		if (is_first_material_of_rock(&list, i))
			add_material_series_of_rock(
			    chart, &list, list.item[i].rock);
	add_loaded_sites_to_param_map(chart, s, false);
	add_loaded_sites_to_param_map(chart, s, true);
	struct chart_extent e = chart_compute_extent(chart);
	chart->x = axis_new_linear("f_mat, kg/(J m)", 0, e.x[1]);
	chart->y = axis_new_linear("e0_min, J m/kg", e.y[0], e.y[1]);
	material_list_free(&list);
	return chart;
}
