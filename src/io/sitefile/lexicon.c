/* Looks words up in one table, without accents: English, Swedish, German,
 * French, Spanish, Portuguese, Finnish, Polish, Italian and some Norwegian,
 * Dutch, Russian and Chinese.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/lexicon.h"

#include <assert.h>
#include <limits.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

/* The terms of ISO 3310 and EN 933-1 in each language, and what people write
 * instead of them. */
static const struct {
	uint64_t means;
	const char *words;
} WORDS[] = {
    {WORD_FEED,
	"feed infeed headfeed inlet input before ingaende inmatning inmatat "
	"pamatning padrag matning fore ragods ramaterial ravara ingods "
	"okrossat utgangsmaterial ursprungsmaterial originalprov aufgabe "
	"aufgabegut aufgabematerial zulauf beschickung vorher alimentation "
	"entree avant alimentacion entrada antes alimentacao syote syotto "
	"ennen pagang nadawa nadawy tilgang alimentazione ingang voeding "
	"питание исходное исходный 给料 进料"},
    {WORD_PRODUCT,
	"product products prod produkt produkte produkter krossprodukt "
	"utgaende utgods utmatning utmatat krossgods fardig fardigvara "
	"slutprodukt ut out output outlet discharge after crushed krossat "
	"krossad efter austrag brechgut endprodukt nachher produit produits "
	"sortie apres concasse broye producto productos salida triturado "
	"despues produto produtos produktu saida britado depois tuote tuotteen "
	"murske jalkeen prodotto prodotti продукт 产品 出料"},
    {WORD_SD,
	"sd stdev stddev std standardavvikelse standardabweichung keskihajonta "
	"desviacion desvio"},
    {WORD_PASSES,
	"passing passings pass passed passes finer undersize through "
	"passerande passerar passerad genomgang genomfall durchgang "
	"siebdurchgang durchgange siebdurchgange tamisat tamisats passant "
	"passants pasa pasan pasante pasantes passante passantes passa "
	"przechodzi przechodzace przesiew lapaisy lapaisee lapaiseva lapaissyt "
	"gjennomgang gennemfald passanti doorval zeefdoorval проход прошло "
	"通过 通过率"},
    {WORD_STAYS,
	"retained retaining ret oversize siktrest kvar stannat stannar "
	"ruckstand siebruckstand ruckstande siebruckstande refus retenu "
	"retenido retenidos retenida retido retida retidos jaanyt jaannos "
	"pozostalosc pozostaje odsiew seulajaannos seulalle rest coarser "
	"trattenuto trattenuti zeefrest остаток остатки 筛余 筛余量 分计筛余"},
    {WORD_SUMS,
	"cum cumul cumulative cumulated accumulated ack ackumulerad "
	"ackumulerat kum kumulativ kumuliert kumulierte kumulierter cumule "
	"cumules cumulee cumulees acum acumulado acumulada acumulados "
	"acumuladas skumulowana skumulowany skumulowane kumulatiivinen "
	"kumulatiivisesti summen kertyma cumulato cumulata cumulativo "
	"cumulativa progressivo cumulatief полный суммарный"},
    {WORD_SHARE,
	"fraction fractions udzial andel anteil anteile fraccion fracao osuus "
	"frazione"},
    {WORD_PERCENT,
	"% pct percent percents percentage perc procent procentuell prozent "
	"procenty pourcent pourcentage porcentaje porciento ciento porcentagem "
	"prosentti prosenttia prosent percento percentuale"},
    {WORD_GRAMS,
	"g gr grm gms gram grams gramme grammes gramm gramos gramas grammaa kg "
	"kilo kilogram kilograms г"},
    {WORD_MASS,
	"mass masses weight weights vikt massa masse massen poids peso pesos "
	"paino gewicht masa masy waga масса 质量"},
    {WORD_SIZE,
	"size sizes sieve sieves sievesize aperture apertures opening openings "
	"screen screens particle grain diameter sikt siktar siktstorlek "
	"siktvidd maskvidd maskstorlek storlek kornstorlek sieb siebe "
	"siebweite sieboffnung siebgrosse siebgroße maschenweite korngrosse "
	"korngroße lochweite nennweite tamis maille mailles ouverture diametre "
	"diametro tamiz tamices malla mallas abertura apertura criba tamano "
	"tamanho peneira peneiras malha malhas seula seulan seulat seulakoko "
	"raekoko sito sita sit oczko oczka otwor silmakoko aukko aukkokoko "
	"dimension maskevidde kornstorrelse sikte d luz setaccio setacci "
	"vaglio vagli maglia maglie luce zeef zeven zeefmaat apning srednica "
	"диаметр сито сита 筛孔 筛孔尺寸 孔径 粒径 筛"},
    {WORD_SIZE | WORD_MESH, "mesh meshes"},
    {WORD_TYLER, "tyler"},
    {WORD_BS, "bs bss"},
    {WORD_ASTM, "astm us ussieve"},
    {WORD_PHI, "phi φ Φ ϕ"},
    {WORD_MM, "mm millimeter millimetre millimetres millimetro milimetro мм"},
    {WORD_UM, "um micron microns mikron micrometer micrometers micrometre "
	      "micrometres mikrometer mikrometri micro micra micras my"},
    {WORD_M, "m meter metre"},
    {WORD_INCH,
	"in inch inches tum zoll pouce pouces pulgada pulgadas pulg polegada "
	"polegadas tuuma tuumaa"},
    {WORD_SPEED,
	"speed velocity tip tipspeed hastighet periferihastighet "
	"rotorhastighet geschwindigkeit umfangsgeschwindigkeit vitesse "
	"predkosc velocidad velocidade nopeus kehanopeus velocita snelheid "
	"скорость 速度 线速度"},
    {WORD_SPEED | WORD_RPM,
	"rpm varvtal drehzahl upm umin pyorimisnopeus obroty obrotow "
	"kierrosluku omdrejningstal turtall giri toerental 转速"},
    {WORD_ROTOR,
	"rotor rotorn rotorns rotors wirnik wirnika rotora roottori roottorin "
	"rotore ротор ротора 转子"},
    {WORD_ROTOR | WORD_SIZE,
	"rotordiameter rotordurchmesser rotordiam rotorhalkaisija"},
    {WORD_LIMIT,
	"min max minimum maximum spec specs specification limit limits lower "
	"upper envelope krav grans undre ovre grenzwert grenze soll sollwert "
	"target granskurva gransvarde limite limites minimo maximo raja "
	"alaraja ylaraja vaatimus norm norma norme unter ober calculated calc "
	"berechnet beraknad beraknat beregnet calcule calculado laskettu "
	"predicted expected simulated simulerad model modell fit fitted "
	"smoothed interpolated rejected outlier discarded kasserad ungultig "
	"previous fuller theoretical teoretisk"},
    {WORD_OTHER,
	"remark remarks note notes comment comments anm anmarkning "
	"anmarkningar bemerkung bemerkungen remarque remarques observaciones "
	"uwaga uwagi wykonal operator observacion observacoes observacao obs "
	"huom huomautus lab labor labno labnr laboratory id time tid klockan "
	"moisture fukt fukthalt feuchte humidite humedad umidade kosteus "
	"temperature temperatur operateur bediener uhrzeit heure hora initials "
	"sampler sampled signature date datum dato fecha data dnia pvm "
	"paivamaara"},
    {WORD_MEAN,
	"mean average avg mw moy ka median gj medel medelvarde snitt mittel "
	"mittelwert moyenne srednia media medio promedio keskiarvo "
	"gjennomsnitt gemiddelde"},
    {WORD_SAMPLE,
	"sample samples prov provet provnr probe proben cut belt beltcut run "
	"runs test trial forsok versuch essai echantillon muestra ensayo "
	"probka proba amostra ensaio nayte koe bandprov band repeat rep "
	"campione prova monster проба 样品 试样"},
    {WORD_SAMPLE | WORD_NUMBER, "no nr n num nummer number numero # n° nº"},
    {WORD_PAN,
	"pan bottom receiver rest botten panna bottenpanna trag bunn boden "
	"siebboden schale denko auffangschale pfanne fond fondo fundo charola "
	"bandeja cazuela pohja bund receptor receptaculo recipiente panela "
	"bodem поддон дно 筛底 底盘"},
    {WORD_TOTAL,
	"sum total totals totalt summa summe gesamt insgesamt somme suma razem "
	"soma totale yhteensa totali totaal итого сумма 合计 总计"},
    {WORD_TOTAL | WORD_WEIGHED, "einwaage invagt m1"},
    {WORD_LOSS,
	"loss losses forlust siktforlust verlust siebverlust perte pertes "
	"strata straty perdida perdidas perda perdas havio havikki difference "
	"perdita perdite verlies потери 损失"},
    {WORD_WASHED,
	"washed washing wash tvatt tvattforlust tvattat abschlammbar "
	"abschlammbare abgeschlammt lavage lave lavado lavagem pesu pesty "
	"pesun waschen gewaschen tvattning tvattad m2"},
    {WORD_MACHINE,
	"vsi crusher kross brecher concasseur trituradora britador murskain "
	"line machine maskin"},
    {WORD_FILLER,
	"at vid material mangd on of the and by to for with a i pa av mit bei "
	"der die das des du de la le en sur par del el por em o wt gew vol "
	"masse-% m m-% med och und et y e astia kohti p v ms s mps peripheral "
	"periferi peripherique periferica periferico analysis siktning each "
	"per je single individual einzeln parcial partiel simple enskild "
	"nominal mtrl на di in частный"},
};

/* Parts of compound words that are enough to tell their meaning:
 * Siebdurchgangsanteil. */
static const struct {
	const char *part;
	uint64_t means;
} PARTS[] = {{"summenruckstand", WORD_STAYS | WORD_SUMS},
    {"summendurchgang", WORD_PASSES | WORD_SUMS}, {"durchgang", WORD_PASSES},
    {"ruckstand", WORD_STAYS}, {"passerande", WORD_PASSES},
    {"siktrest", WORD_STAYS}, {"lapaisy", WORD_PASSES}, {"cumul", WORD_SUMS},
    {"kumul", WORD_SUMS}, {"ackumul", WORD_SUMS}, {"acumul", WORD_SUMS},
    {"prozent", WORD_PERCENT}, {"procent", WORD_PERCENT},
    {"percent", WORD_PERCENT}, {"hastighet", WORD_SPEED},
    {"geschwindigkeit", WORD_SPEED}, {"drehzahl", WORD_SPEED | WORD_RPM},
    {"varvtal", WORD_SPEED | WORD_RPM}, {"maschenweit", WORD_SIZE},
    {"korngro", WORD_SIZE}, {"siebgro", WORD_SIZE}, {"siktstorl", WORD_SIZE},
    {"maskvidd", WORD_SIZE}, {"siebweite", WORD_SIZE}, {"aufgabe", WORD_FEED},
    {"produkt", WORD_PRODUCT}, {"retained", WORD_STAYS},
    {"passing", WORD_PASSES}, {"product", WORD_PRODUCT}, {"feed", WORD_FEED},
    {"syote", WORD_FEED}, {"jaav", WORD_STAYS}, {"tuote", WORD_PRODUCT},
    {"gewicht", WORD_MASS}, {"einwaage", WORD_TOTAL | WORD_WEIGHED},
    {"累计筛余", WORD_STAYS | WORD_SUMS}};

struct known {
	const char *word;
	size_t n;
	uint64_t means;
};

/* word: all words, each once, sorted by their bytes.  begins: the first two
 * bytes of all PARTS, so that a long text is searched in time proportional to
 * its length. */
struct index {
	struct known word[1024];
	size_t n, longest;
	bool begins[UCHAR_MAX + 1][UCHAR_MAX + 1];
};

/* Returns the one index, which lexicon_word_meanings fills at its first
 * call. */
static struct index *
lexicon_get_lookup_table(void)
{
	static struct index index;
	return &index;
}

static int
compare_known_words(const void *a, const void *b)
{
	const struct known *x = a, *y = b;
	int order = memcmp(x->word, y->word, x->n < y->n ? x->n : y->n);
	return order != 0 ? order : (x->n > y->n) - (x->n < y->n);
}

static void
fill_lexicon_index(void)
{
	struct index *index = lexicon_get_lookup_table();
	struct known *word = index->word;
	size_t n = 0, all = 0;
	for (size_t i = 0; i < ARRAY_LEN(WORDS); i++)
		for (const char *p = WORDS[i].words; *p != '\0';) {
			size_t length = strcspn(p, " ");
			assert(all < ARRAY_LEN(index->word));
			word[all++] = (struct known){p, length, WORDS[i].means};
			if (length > index->longest)
				index->longest = length;
			p += length + (p[length] == ' ');
		}
	qsort(word, all, sizeof *word, compare_known_words);
	for (size_t i = 0; i < all; i++)
		if (n > 0 && compare_known_words(&word[n - 1], &word[i]) == 0)
			word[n - 1].means |= word[i].means;
		else
			word[n++] = word[i];
	index->n = n;
	for (size_t i = 0; i < ARRAY_LEN(PARTS); i++) {
		const unsigned char *p = (const unsigned char *)PARTS[i].part;
		index->begins[p[0]][p[1]] = true;
	}
}

/* Returns the meanings of the first of PARTS that a word contains, or 0. */
static uint64_t
meanings_of_contained_word(
    const struct index *index, const char *word, size_t n)
{
	const unsigned char *p = (const unsigned char *)word;
	size_t best = ARRAY_LEN(PARTS);
	for (size_t at = 0; at + 1 < n; at++) {
		if (!index->begins[p[at]][p[at + 1]])
			continue;
		for (size_t i = 0; i < best; i++) {
			size_t length = strlen(PARTS[i].part);
			if (length <= n - at &&
			    memcmp(word + at, PARTS[i].part, length) == 0)
				best = i;
		}
	}
	return best < ARRAY_LEN(PARTS) ? PARTS[best].means : 0;
}

/* Returns the meanings shared by all words that begin with an abbreviation
 * ("umfangsgeschw." without its point), or 0. */
static uint64_t
meanings_of_abbreviation(const char *start, size_t n)
{
	enum { LEAST = 4 }; /* "apr" and "mar" are months */
	const struct index *index = lexicon_get_lookup_table();
	uint64_t shared = 0;
	bool any = false;
	for (size_t i = 0; n >= LEAST && i < index->n; i++) {
		const struct known *known = &index->word[i];
		if (known->n <= n || memcmp(known->word, start, n) != 0)
			continue;
		shared = any ? shared & known->means : known->means;
		any = true;
	}
	return shared;
}

uint64_t
lexicon_word_meanings(const char *word, size_t n)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	const struct index *index = lexicon_get_lookup_table();
	const struct known wanted = {word, n, 0}, *found = NULL;
	pthread_once(&once, fill_lexicon_index);
	if (n > 0 && n <= index->longest)
		found = bsearch(&wanted, index->word, index->n,
		    sizeof index->word[0], compare_known_words);
	return found != NULL ? found->means
			     : meanings_of_contained_word(index, word, n);
}

uint64_t
lexicon_text_meanings(const char *text, size_t *unknown)
{
	static const char LETTERS[] = "abcdefghijklmnopqrstuvwxyz0123456789";
	FREED char *folded = text_fold_case_and_accents(text);
	uint64_t means = 0;
	size_t none = 0;
	for (char *p = folded; *p != '\0';) {
		/* text_fold_case_and_accents keeps both signs for micro. */
		char *word = p;
		while (*p != '\0' &&
		       (strchr(LETTERS, *p) != NULL || (*p & 0x80) != 0))
			p++;
		if (p == word)
			p++;
		if (word[0] == '%' || word[0] == '#' || p > word + 1 ||
		    strchr(LETTERS, word[0]) != NULL) {
			bool micro = p - word == 3 && word[2] == 'm' &&
				     (memcmp(word, "\xC2\xB5", 2) == 0 ||
					 memcmp(word, "\xCE\xBC", 2) == 0);
			uint64_t one = micro ? WORD_UM
					     : lexicon_word_meanings(
						   word, (size_t)(p - word));
			if (one == 0 && *p == '.')
				one = meanings_of_abbreviation(
				    word, (size_t)(p - word));
			bool digits =
			    strspn(word, "0123456789") >= (size_t)(p - word);
			none += one == 0 && !digits;
			means |= one;
		}
	}
	if (unknown != NULL)
		*unknown = none;
	return means;
}

/* Words of time in English, Swedish and German. */
static const char TIMES[] =
    " mon monday tue tues tuesday wed wednesday thu thur thurs thursday fri "
    "friday sat saturday sun sunday mandag tis tisdag ons onsdag tor tors "
    "torsdag fre fredag lor lordag son sondag montag dienstag mittwoch "
    "donnerstag freitag samstag sonnabend sonntag jan january januari januar "
    "feb february februari februar mar march mars marz apr april may maj mai "
    "jun june juni jul july juli aug august augusti sep sept september oct "
    "okt october oktober nov november dec dez december dezember morning noon "
    "afternoon evening night morgon formiddag eftermiddag kvall natt morgen "
    "vormittag nachmittag abend nacht shift skift schicht week vecka woche "
    "day dag tag again igen nochmal ";

bool
lexicon_is_word_of_time(const char *word)
{
	FREED char *whole = xasprintf(" %s ", word);
	return strstr(TIMES, whole) != NULL;
}

/* Parts of words in the labels of dates: of any date, of the day of sampling,
 * and of other days. */
static const char *const DAYS[] = {"date", "datum", "dato", "fecha", "data",
    "dnia", "pvm", "paivamaara", "sampled", "provta", "provdat", "probenahme",
    "entnahme"};
static const char *const SAMPLING[] = {
    "sampl", "provta", "provdat", "probenahme", "entnahme", "taken", "cut"};
static const char *const OTHER_DAYS[] = {"analy", "siev", "sikt", "sieb",
    "pruf", "report", "rapport", "receiv", "ankom", "eingang", "print",
    "utskr"};

static bool
contains_any_substring(const char *folded, const char *const *part, size_t n)
{
	for (size_t i = 0; i < n; i++)
		if (strstr(folded, part[i]) != NULL)
			return true;
	return false;
}

enum lexicon_day
lexicon_day_kind_of_label(const char *label)
{
	FREED char *folded = text_fold_case_and_accents(label);
	if (contains_any_substring(folded, OTHER_DAYS, ARRAY_LEN(OTHER_DAYS)))
		return DAY_OTHER;
	if (!contains_any_substring(folded, DAYS, ARRAY_LEN(DAYS)))
		return DAY_NONE;
	return contains_any_substring(folded, SAMPLING, ARRAY_LEN(SAMPLING))
		   ? DAY_SAMPLED
		   : DAY_ANY;
}

bool
lexicon_is_date_label(const char *label)
{
	return lexicon_day_kind_of_label(label) >= DAY_ANY;
}

/* The keys, folded by text_fold_case_and_accents.  The first of each is that of
 * tipspeed-site(5). */
static const char *const KEYS[N_KEY] = {
    [KEY_SITE] =
	"site|quarry|plant|anlaggning|bergtakt|takt|taktort|plats|werk|"
	"steinbruch|anlage|carriere|cantera|planta|pedreira|louhos|"
	"sorakuoppa|site name",
    [KEY_ROCK] = "rock|rock type|bergart|gestein|gesteinsart|roche|roca|rocha|"
		 "kivilaji",
    [KEY_MACHINE] = "machine|crusher|maskin|kross|brecher|maschine|concasseur|"
		    "trituradora|britador|murskain",
    [KEY_PROVENANCE] = "provenance|source|ursprung|kalla|herkunft|provenienz|"
		       "origine|procedencia|origen|origem|alkupera|lahde",
    [KEY_TOP_SIZE] = "top_size_mm|top size mm|top size (mm)",
};

static bool
is_key_in_list(const char *key, const char *list)
{
	FREED char *folded = text_fold_case_and_accents(key);
	const char *word = text_trim(folded);
	size_t n = strlen(word);
	n -= n > 1 && word[n - 1] == ':';
	n -= n > 1 && word[n - 1] == ' ';
	for (const char *p = list; n > 0 && *p != '\0';) {
		size_t length = strcspn(p, "|");
		if (length == n && strncmp(p, word, n) == 0)
			return true;
		p += length + (p[length] == '|');
	}
	return false;
}

enum lexicon_key
lexicon_site_key_of_text(const char *text)
{
	size_t k = 0;
	while (k < N_KEY && !is_key_in_list(text, KEYS[k]))
		k++;
	return (enum lexicon_key)k;
}

bool
lexicon_is_label_of_sites(const char *label)
{
	FREED char *copy = xstrdup(label);
	char *more = copy + strcspn(copy, " ");
	if (is_key_in_list(more, "no|no.|nr|nr.|number|nummer|#|id|name|namn"))
		*more = '\0';
	enum lexicon_key key = lexicon_site_key_of_text(copy);
	return key == KEY_SITE || key == KEY_MACHINE;
}
