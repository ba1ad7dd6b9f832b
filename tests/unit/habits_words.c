/* Words of seven languages, and numbers as they are typed there.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "habits.h"

const struct tongue TONGUES[7] = {
    {"en", false,
	{"Sieve", "Sieve size", "Aperture", "Mesh size", "Size", "Opening"},
	{"Feed", "Feed", "Crusher feed", "Feed sample", "VSI feed",
	    "Feed to VSI"},
	{"Product", "Product", "Crushed product", "Product sample",
	    "VSI product", "Discharge"},
	{"passing", "Passing", "cumulative passing", "finer"},
	{"retained", "Retained", "retained on sieve", "mass retained"},
	{"cumulative retained", "cum. retained", "Cum retained"},
	{"Pan", "pan", "Receiver"}, {"Total", "Sum", "total"},
	{"%", "wt%", "% by mass"}, "Sample", "Tip speed", "Rotor diameter",
	"Sieve analysis", "Site", "Rock", "Date", "Operator", "Remarks",
	"Spec min", "Spec max", "Total dry mass M1",
	"Dry mass after washing M2", "Loss", "Fineness modulus", "Lab no.",
	"fraction"},
    {"sv", true,
	{"Sikt", "Maskvidd", "Siktstorlek", "Kornstorlek", "Sikt",
	    "Fri "
	    "maskvidd"},
	{"Ingående", "Ingående material", "Inmatning", "Påmatning", "Matning",
	    "Ingående"},
	{"Produkt", "Produkt", "Utgående", "Krossprodukt", "Produkt",
	    "Utgående"},
	{"passerande", "Passerande", "passerande mängd", "passerar"},
	{"siktrest", "Siktrest", "stannar på sikt", "kvar på sikt"},
	{"ackumulerad siktrest", "ack. siktrest", "Ack siktrest"},
	{"Botten", "botten", "Tråg"}, {"Summa", "Totalt", "Summa"},
	{"%", "vikt-%", "vikt%"}, "Prov", "Periferihastighet", "Rotordiameter",
	"Siktanalys", "Anläggning", "Bergart", "Datum", "Signatur",
	"Anmärkning", "Gräns min", "Gräns max", "Total torr massa M1",
	"Torr massa efter tvättning M2", "Förlust", "Finhetsmodul", "Labnr",
	"andel"},
    {"de", true,
	{"Sieb", "Maschenweite", "Siebgröße", "Korngröße", "Siebweite",
	    "Maschenweite"},
	{"Aufgabe", "Aufgabegut", "Aufgabe", "Aufgabematerial", "Aufgabe",
	    "Aufgabegut"},
	{"Produkt", "Produkt", "Austrag", "Brechprodukt", "Fertiggut",
	    "Austrag"},
	{"Durchgang", "Siebdurchgang", "Summendurchgang", "Durchgang"},
	{"Rückstand", "Siebrückstand", "Rückstand", "Masse Rückstand"},
	{"Rückstand kumuliert", "Summenrückstand", "kum. Rückstand"},
	{"Boden", "Schale", "Auffangschale"}, {"Summe", "Gesamt", "Summe"},
	{"%", "M.-%", "Gew.-%"}, "Probe", "Umfangsgeschwindigkeit",
	"Rotordurchmesser", "Siebanalyse", "Werk", "Gestein", "Datum", "Prüfer",
	"Bemerkung", "Grenze min", "Grenze max", "Trockenmasse gesamt M1",
	"Trockenmasse nach dem Waschen M2", "Siebverlust", "Feinheitsmodul",
	"Labor-Nr.", "Anteil"},
    {"fr", true,
	{"Tamis", "Ouverture", "Maille", "Ouverture de maille", "Tamis",
	    "Dimension"},
	{"Alimentation", "Alimentation", "Entrée", "Alimentation", "Entrée",
	    "Alimentation"},
	{"Produit", "Produit", "Sortie", "Produit broyé", "Produit", "Sortie"},
	{"passant", "Passants", "Tamisat", "passants cumulés"},
	{"refus", "Refus", "refus partiel", "masse des refus"},
	{"refus cumulé", "Refus cumulés", "refus cumulé"},
	{"Fond", "fond", "Fond de tamis"}, {"Total", "Somme", "Total"},
	{"%", "% massique", "%"}, "Échantillon", "Vitesse périphérique",
	"Diamètre du rotor", "Analyse granulométrique", "Carrière", "Roche",
	"Date", "Opérateur", "Remarques", "Limite inférieure",
	"Limite supérieure", "Masse sèche totale M1",
	"Masse sèche après lavage M2", "Perte", "Module de finesse", "N° labo",
	"fraction"},
    {"es", true, {"Tamiz", "Abertura", "Malla", "Tamaño", "Tamiz", "Abertura"},
	{"Alimentación", "Alimentación", "Alimentación", "Entrada",
	    "Alimentación", "Entrada"},
	{"Producto", "Producto", "Producto", "Salida", "Producto", "Salida"},
	{"pasa", "Pasante", "que pasa", "pasante acumulado"},
	{"retenido", "Retenido", "retenido parcial", "masa retenida"},
	{"retenido acumulado", "Retenido acumulado", "ret. acumulado"},
	{"Fondo", "fondo", "Bandeja"}, {"Total", "Suma", "Total"},
	{"%", "% en peso", "%"}, "Muestra", "Velocidad periférica",
	"Diámetro del rotor", "Análisis granulométrico", "Planta", "Roca",
	"Fecha", "Operador", "Observaciones", "Límite inferior",
	"Límite superior", "Masa seca total M1", "Masa seca tras lavado M2",
	"Pérdida", "Módulo de finura", "N.º laboratorio", "fracción"},
    {"pt", true,
	{"Peneira", "Abertura", "Malha", "Tamanho", "Peneira", "Abertura"},
	{"Alimentação", "Alimentação", "Alimentação", "Entrada", "Alimentação",
	    "Entrada"},
	{"Produto", "Produto", "Produto", "Saída", "Produto", "Saída"},
	{"passante", "Passante", "que passa", "passante acumulado"},
	{"retido", "Retido", "massa retida", "retida"},
	{"retido acumulado", "Retida acumulada", "ret. acumulado"},
	{"Fundo", "fundo", "Fundo"}, {"Total", "Soma", "Total"},
	{"%", "% em massa", "%"}, "Amostra", "Velocidade periférica",
	"Diâmetro do rotor", "Análise granulométrica", "Pedreira", "Rocha",
	"Data", "Operador", "Observações", "Limite inferior", "Limite superior",
	"Massa seca total M1", "Massa seca após lavagem M2", "Perda",
	"Módulo de finura", "N.º laboratório", "fração"},
    {"fi", true,
	{"Seula", "Seulakoko", "Seulan aukko", "Raekoko", "Seula", "Aukko"},
	{"Syöte", "Syöte", "Syötemateriaali", "Syöte", "Syöte", "Syöte"},
	{"Tuote", "Tuote", "Murskattu tuote", "Tuote", "Tuote", "Tuote"},
	{"läpäisy", "Läpäisy", "läpäisevä", "Läpäisyprosentti"},
	{"seulalle jäänyt", "Seulalle jäänyt", "seulalle jäävä",
	    "jäänyt seulalle"},
	{"kumulatiivinen seulalle jäänyt", "Kumul. seulalle jäänyt",
	    "kumulatiivinen jäänyt"},
	{"Pohja", "pohja", "Pohja-astia"}, {"Yhteensä", "Summa", "Yhteensä"},
	{"%", "paino-%", "p-%"}, "Näyte", "Kehänopeus", "Roottorin halkaisija",
	"Seulontatulos", "Laitos", "Kivilaji", "Pvm", "Tekijä", "Huomautus",
	"Alaraja", "Yläraja", "Kuivamassa M1", "Kuivamassa pesun jälkeen M2",
	"Hävikki", "Hienousmoduuli", "Lab.nro", "osuus"},
};

const char *
plan_word(const struct plan *plan, const char *const *words, size_t most)
{
	return words[(size_t)plan->word % most];
}

static bool
is_grams(enum written quantity)
{
	return quantity == HELD_G || quantity == SUM_G;
}

static bool
is_share(enum written quantity)
{
	return quantity == PASS_SHARE || quantity == HELD_SHARE ||
	       quantity == SUM_SHARE;
}

const char *
quantity_word(const struct plan *plan, enum written quantity)
{
	const struct tongue *t = plan->tongue;
	return quantity <= PASS_SHARE   ? plan_word(plan, t->passing, 4)
	       : quantity <= HELD_SHARE ? plan_word(plan, t->held, 4)
					: plan_word(plan, t->sum, 3);
}

const char *
quantity_unit(const struct plan *plan, enum written quantity)
{
	return is_grams(quantity)   ? "g"
	       : is_share(quantity) ? plan->tongue->share
				    : plan_word(plan, plan->tongue->unit, 3);
}

/* "Siebrückstand [g]". */
char *
plan_quantity(const struct plan *plan, enum written quantity)
{
	const char *unit = quantity_unit(plan, quantity);
	char *word = plan_upper(plan, quantity_word(plan, quantity)), *text;
	switch (plan->word / 4 % 4) {
	case 0:
		text = xasprintf("%s (%s)", word, unit);
		break;
	case 1:
		text = xasprintf("%s [%s]", word, unit);
		break;
	case 2:
		text = unit[0] == '%' ? xasprintf("%s %s", unit, word)
				      : xasprintf("%s %s", word, unit);
		break;
	default:
		text = xasprintf("%s, %s", word, unit);
	}
	free(word);
	return text;
}

/* Letters of Latin-1 in UTF-8 are C3 80 to C3 BF. */
char *
plan_upper(const struct plan *plan, const char *text)
{
	static const char PLAIN[] = "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTs"
				    "aaaaaaaceeeeiiiidnooooo/ouuuuyty";
	char *copy = xstrdup(text), *to = copy;
	for (const unsigned char *p = (const unsigned char *)text; *p != '\0';
	     p++) {
		if (*p == 0xC3 && plan->no_accents) {
			unsigned char c = (unsigned char)PLAIN[*++p & 0x3F];
			*to++ = (char)(plan->upper ? toupper(c) : c);
		} else if (*p == 0xC3) {
			*to++ = (char)*p++;
			bool small = *p >= 0xA0 && *p != 0xB7 && *p != 0xBF;
			*to++ = (char)(plan->upper && small ? *p - 0x20 : *p);
		} else {
			*to++ =
			    (char)(plan->upper && *p < 0x80 ? toupper(*p) : *p);
		}
	}
	*to = '\0';
	return copy;
}

/* "Feed" or "Product" in one of the words of a language. */
char *
plan_role(const struct plan *plan, bool feed)
{
	return plan_upper(
	    plan, plan_word(plan,
		      feed ? plan->tongue->feed : plan->tongue->product, 6));
}

char *
plan_number(const struct plan *plan, double value, int decimals)
{
	char digits[64];
	snprintf(digits, sizeof digits, "%.*f", decimals, value);
	char *text = xstrdup("");
	size_t whole = strcspn(digits, ".");
	for (size_t i = 0; digits[i] != '\0'; i++) {
		bool group = i > 0 && i < whole && (whole - i) % 3 == 0 &&
			     digits[i - 1] != '-';
		if (group && plan->thousands != NULL)
			xappend(&text, "%s", plan->thousands);
		xappend(
		    &text, "%c", digits[i] == '.' ? plan->decimal : digits[i]);
	}
	return text;
}

/* With as many decimals as it has, up to `most`. */
char *
plan_short(const struct plan *plan, double value, int most)
{
	int decimals = 0;
	double scale = 1;
	while (decimals < most &&
	       fabs(round(value * scale) / scale - value) > 1e-9 * value) {
		decimals++;
		scale *= 10;
	}
	return plan_number(plan, value, decimals);
}
