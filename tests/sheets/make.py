#!/usr/bin/python3
# Makes the sheets of this folder anew, with real programs where there are such:
# LibreOffice, gnumeric, R, openpyxl.  For maintainers; no test runs it.
#   apt-get install --no-install-recommends libreoffice-calc gnumeric \
#       r-base-core python3-openpyxl locales-all
#   tests/sheets/make.py
# All say what same.is says, unless LIST says otherwise.  Which programs made
# those of the last run stands in MADE-BY.
# SPDX-License-Identifier: GPL-3.0-or-later
import datetime
import math
import os
import subprocess
import tempfile
import zipfile

import openpyxl
from openpyxl.styles import Alignment

os.chdir(os.path.dirname(os.path.abspath(__file__)))
TMP = tempfile.mkdtemp()
MM = [22.4, 16, 11.2, 8, 5.6, 4, 2, 1, 0.5, 0.25, 0.125, 0.063]
FEED = [100, 95.2, 90, 62.8, 42.9, 29.9, 14.3, 6.8, 3.2, 1.5, 0.7, 0.4]
P69 = [100, 99.5, 97.8, 92.9, 79.8, 59.6, 30.2, 15.9, 7, 3.7, 1.9, 0.9]
P79 = [100, 99.4, 97.9, 93.2, 83.8, 69.3, 36.2, 19.7, 9.2, 4.4, 2.3, 1.2]
P69B = [100, 99.4, 97.5, 92.6, 79.3, 59.2, 30.8, 16.2, 7.2, 3.7, 1.8, 0.8]
CURVES = [FEED, P69, P79]
MASS = [5000, 2000, 2500]
ASTM = ['7/8 in', '5/8 in', '7/16 in', '5/16 in', 'No. 3 1/2', 'No. 5',
        '#10', 'No. 18', 'No. 35', '#60', 'No. 120', 'No. 230']
DAY = datetime.date(2026, 5, 3)


def held(curve, mass):
    """Grams on each sieve and in the pan."""
    above = [100] + curve[:-1]
    on = [round((a - p) * mass / 100, 1) for a, p in zip(above, curve)]
    return on + [round(curve[-1] * mass / 100, 1)]


GRAMS = [held(c, m) for c, m in zip(CURVES, MASS)]


def text(x, decimal='.', thousands=''):
    if isinstance(x, str):
        return x
    if x is None:
        return ''
    s = '%.10g' % x
    whole, _, part = s.partition('.')
    if thousands and len(whole) > 3:
        whole = whole[:-3] + thousands + whole[-3:]
    return whole + (decimal + part if part else '')


def put(name, rows, sep=',', decimal='.', thousands='', end='\n',
        coding='utf-8', pad=False):
    """A sheet as somebody types it."""
    width = max(len(r) for r in rows)
    lines = []
    for r in rows:
        cells = [text(c, decimal, thousands) for c in r]
        if pad:
            cells += [''] * (width - len(cells))
        cells = ['"' + c.replace('"', '""') + '"' if sep in c or '"' in c
                 else c for c in cells]
        lines.append(sep.join(cells))
    with open(name, 'wb') as f:
        f.write((end.join(lines) + end).encode(coding))


def rows_of(head, curves=CURVES, sizes=MM):
    return [head] + [[s] + [c[i] for c in curves]
                     for i, s in enumerate(sizes)]


def rows_of_grams(head, total='Summa', pan='Botten', grams=GRAMS):
    rows = [head] + [[s] + [g[i] for g in grams]
                     for i, s in enumerate(MM + [pan])]
    return rows + ([[total] + [round(sum(g), 1) for g in grams]]
                   if total else [])


def turned(rows):
    return [list(r) for r in zip(*rows)]


# --- the truths
put('same.is', rows_of(['size_mm', 'feed', 'product@69', 'product@79']))
put('one.is', rows_of(['size_mm', 'feed', 'product@72'], [FEED, P69]))
put('cut.is', rows_of(['size_mm', 'product@72'], [P69]))
put('feed.is', rows_of(['size_mm', 'feed'], [FEED]))
put('repeats.is', rows_of(
    ['size_mm', 'feed', 'product@69', 'product@69', 'product@79'],
    [FEED, P69, P69B, P79]))
GAPS = [FEED, [None] + P69[1:], [None] + P79[1:5] + [None] + P79[6:]]
put('gaps.is', rows_of(['size_mm', 'feed', 'product@69', 'product@79'], GAPS))
COARSE = [i for i, s in enumerate(MM) if s not in (11.2, 0.5)]
put('apart.is', [['size_mm', 'feed', 'product@69', 'product@79']] + [
    [s, FEED[i] if i in COARSE else None, P69[i], P79[i]]
    for i, s in enumerate(MM)])
JUNE = [FEED, P69B, P79]
put('june.is', rows_of(['size_mm', 'feed', 'product@69', 'product@79'], JUNE))
WASH = [[96.0 + 0.04 * p if p == 100 else round(3 + 0.97 * p, 2) for p in c]
        for c in CURVES]
put('washed.is', rows_of(['size_mm', 'feed', 'product@69', 'product@79'], WASH))

# --- the 20 habits of the review
HEADS_SV = ['Sikt (mm)', 'Ingående', 'Produkt 69 m/s', 'Produkt 79 m/s']
put('habit-01.csv', [['Siktanalys, Berga, 3 maj'], []] + rows_of(HEADS_SV),
    ';', ',', end='\r\n')
put('habit-02.csv', rows_of_grams(
    ['Sikt mm', 'Feed siktrest (g)', 'Produkt 69 m/s siktrest (g)',
     'Produkt 79 m/s siktrest (g)']), ';', ',')
put('habit-03.csv', rows_of_grams(
    ['Sikt mm', 'Ingående g', '69 m/s g', '79 m/s g']), ';', ',', ' ')
put('habit-04.csv', rows_of(HEADS_SV, GAPS), ';', ',')
put('habit-06.csv', [['Rotor diameter (mm)', 900]] + rows_of(
    ['Sieve (mm)', 'Feed', 'Product 1464 rpm', 'Product 1676 rpm']))
put('habit-06-asks.csv', rows_of(
    ['Sieve (mm)', 'Feed', 'Product 1464 rpm', 'Product 1676 rpm']))
put('habit-07-feed.csv', rows_of(['Sieve (mm)', 'Passing (%)'], [FEED]))
put('habit-07-cut1.csv', rows_of(['Sieve (mm)', 'Passing (%)'], [P69]))
put('habit-07-cut2.csv', rows_of(['Sieve (mm)', 'Passing (%)'], [P79]))
for name, role, speed, curve in (('feed', 'Feed', None, FEED),
                                 ('cut1', 'Product', '69 m/s', P69),
                                 ('cut2', 'Product', '79 m/s', P79)):
    put('cuts-header-%s.csv' % name,
        [['Sample', role]] + ([['Tip speed', speed]] if speed else []) +
        [[]] + rows_of(['Sieve (mm)', 'Passing (%)'], [curve]))
put('habit-08.csv', rows_of(
    ['Sieve', 'Feed % passing', '69 m/s % passing', '79 m/s % passing'],
    sizes=ASTM))
put('habit-09.csv', turned(rows_of(
    ['Sieve (mm)', 'Feed', 'Product 69 m/s', 'Product 79 m/s'])))
LONG = [['sample', 'tip speed (m/s)', 'sieve (mm)', 'passing (%)']]
for role, speed, curve in (('feed', None, FEED), ('product', 69, P69),
                           ('product', 79, P79)):
    LONG += [[role, speed, s, p] for s, p in zip(MM, curve)]
put('habit-10.csv', LONG)
put('habit-11.csv', [['', 'Feed', 'Product', ''],
                     ['Sieve (mm)', '', '69 m/s', '79 m/s']] + rows_of([])[1:])
put('habit-12.csv', rows_of(['Size (mm)', 'Feed', '69 m/s', '79 m/s'])[:1] +
    rows_of([])[:0:-1])
put('habit-13.csv', rows_of(
    HEADS_SV, [['-' if p is None else p for p in c] for c in GAPS]), ';', ',')
put('habit-14.csv', rows_of_grams(
    ['Sieve (mm)', 'Feed (g)', 'Product 69 m/s (g)', 'Product 79 m/s (g)'],
    'Total', 'Pan'), ';', '.', ',')
put('habit-15.csv', rows_of(
    ['Sieve (mm)', 'Feed', 'Product 69 m/s', 'Product 69 m/s',
     'Product 79 m/s'], [FEED, P69, P69B, P79]))
put('habit-16.csv', rows_of(['Sieve (mm)', 'Feed', 'Product 72 m/s'],
                            [FEED, P69]))
put('habit-16-cut.csv', rows_of(['Sieve (mm)', 'Product 72 m/s'], [P69]))
put('habit-19.csv', rows_of_grams(['Sieve (mm)', 'Feed', '69 m/s', '79 m/s'],
                                  'Total', 'Pan'))
put('habit-20.csv', rows_of(['Sikt (mm)', 'Ingående', 'Produkt 69',
                             'Produkt 79']), ';', ',')

# --- 16 heads that come naturally
HEADS = [('Feed', 'Product 69.0', 'Product 79.0'),
         ('Feed', 'Product 69 m/s', 'Product 79 m/s'),
         ('Feed', '1464 rpm (69 m/s)', '1676 rpm (79 m/s)'),
         ('Ingående', 'Prov 1 69 m/s', 'Prov 2 79 m/s'),
         ('Ingående', 'Prov 1, 69,0 m/s', 'Prov 2, 79,0 m/s'),
         ('Feed', 'Product (69 m/s)', 'Product (79 m/s)'),
         ('Feed', 'Product 1 - 69 m/s', 'Product 2 - 79 m/s'),
         ('FEED', 'PRODUCT 69 M/S', 'PRODUCT 79 M/S'),
         ('Aufgabe', 'Produkt bei 69 m/s', 'Produkt bei 79 m/s'),
         ('Alimentation', 'Produit à 69 m/s', 'Produit à 79 m/s'),
         ('Alimentación', 'Producto v=69 m/s', 'Producto v=79 m/s'),
         ('Alimentação', 'Produto 69m/s', 'Produto 79m/s'),
         ('Syöte', 'Tuote 69 m/s', 'Tuote 79 m/s'),
         ('Crusher feed', 'Crusher product @ 69', 'Crusher product @ 79'),
         ('Feed passing %', '% passing, 69 m/s', '% passing, 79 m/s'),
         ('Feed', 'Belt cut 13583 ft/min', 'Belt cut 15551 ft/min')]
for i, (feed, a, b) in enumerate(HEADS):
    put('heads-%02d.csv' % (i + 1), rows_of(['mm', feed, a, b]), ';',
        ',' if '69,0' in a else '.')

# --- others, by hand
put('tyler.csv', [['Tyler mesh', 'Feed', 'Product 69 m/s', 'Product 79 m/s']] +
    rows_of([], sizes=['22.4 mm', '16 mm', '11.2 mm', '8 mm', '3 1/2', '5',
                       '9', '16', '32', '60', '115', '250'])[1:])
put('bs.csv', [['Sieve', 'Feed', 'Product 69 m/s', 'Product 79 m/s']] +
    rows_of([], sizes=['22.4 mm', '16 mm', '11.2 mm', '8 mm', '5.6 mm', '4 mm',
                       'BS 8 mesh', 'BS 16 mesh', 'BS 30 mesh', 'BS 60 mesh',
                       'BS 120 mesh', 'BS 240 mesh'])[1:])
put('mesh-asks.csv',
    [['Mesh', 'Feed', 'Product 69 m/s', 'Product 79 m/s']] +
    [r for r in rows_of([], sizes=['1 in', '3/4 in', '1/2 in', '3/8 in', '3',
                                   '5', '8', '16', '30', '60', '120',
                                   '240'])[1:]])
put('um.csv', rows_of(['Maschenweite (µm)', 'Aufgabe Durchgang %',
                       'Produkt 69 m/s Durchgang %',
                       'Produkt 79 m/s Durchgang %'],
                      sizes=[round(s * 1000) for s in MM]), ';', ',', '.')
put('utf16.csv', [['Siktanalys, Önnestad']] + rows_of(HEADS_SV), '\t', ',',
    coding='utf-16', end='\r\n')
put('decomposed.csv', [['Siktanalys']] + rows_of(
    ['Sikt (mm)', 'Inga\u030aende', 'Produkt 69 m/s', 'Produkt 79 m/s']))
put('apart-below.csv', [['Feed']] + [['Sieve (mm)', 'Passing (%)']] +
    [[MM[i], FEED[i]] for i in COARSE] + [[], ['Product']] +
    rows_of(['Sieve (mm)', '69 m/s', '79 m/s'], [P69, P79]), pad=True)
put('apart-beside.csv', [
    ['Feed', '', '', 'Product'],
    ['mm', 'Passing (%)', '', 'mm', '69 m/s', '79 m/s']] + [
        ([MM[COARSE[i]], FEED[COARSE[i]]] if i < len(COARSE) else ['', '']) +
        ['', s, P69[i], P79[i]] for i, s in enumerate(MM)], ';', ',')
put('two-tables-asks.csv', [['May']] + rows_of(HEADS_SV) + [[], ['June']] +
    rows_of(HEADS_SV, JUNE), ';', ',')
put('ordinals-asks.csv', rows_of(['Sieve (mm)', 'Feed', 'Product 1',
                                  'Product 2']))
put('no-unit-asks.csv', rows_of(['Sieve', 'Feed', 'Product 69 m/s',
                                 'Product 79 m/s'],
                                sizes=[round(s / .0254) for s in MM]))
put('limits.csv', [['Sieve (mm)', 'Spec min', 'Spec max', 'Feed', '69 m/s',
                    '79 m/s', 'Remarks']] +
    [[s, max(0, round(FEED[i]) - 9), min(100, round(P79[i]) + 9), FEED[i],
      P69[i], P79[i], 'dry' if i == 3 else ''] for i, s in enumerate(MM)])


def with_loss(grams, lost):
    return [[g[0], g[1], g[2] - lost] + g[3:] for g in grams]


put('loss.csv', rows_of_grams(
    ['Sieve mm', 'Feed retained (g)', 'Product 69 m/s retained (g)',
     'Product 79 m/s retained (g)'], 'Total', 'Pan', with_loss(GRAMS, 5)) +
    [['Total dry mass M1'] + MASS], ';', '.')
put('loss-much-refused.csv', rows_of_grams(
    ['Sieve mm', 'Feed retained (g)', 'Product 69 m/s retained (g)',
     'Product 79 m/s retained (g)'], None, 'Pan', with_loss(GRAMS, 60)) +
    [['Total dry mass M1'] + MASS], ';', '.')
WGRAMS = []
for c, m in zip(CURVES, MASS):
    g = held(c, m * 0.97)
    WGRAMS.append([round(x, 1) for x in g])
put('washed.csv', rows_of_grams(
    ['Sieb (mm)', 'Aufgabe Rückstand (g)', 'Produkt 69 m/s Rückstand (g)',
     'Produkt 79 m/s Rückstand (g)'], None, 'Boden', WGRAMS) + [
         ['Trockenmasse gesamt M1'] + MASS,
         ['Trockenmasse nach dem Waschen M2'] +
         [round(m * 0.97, 1) for m in MASS]], ';', ',')
put('cumulative-g.csv', [
    ['Tamis (mm)', 'Alimentation refus cumulé (g)',
     'Produit 69 m/s refus cumulé (g)', 'Produit 79 m/s refus cumulé (g)']] + [
         [s] + [round((100 - c[i]) * m / 100, 1) for c, m in zip(CURVES, MASS)]
         for i, s in enumerate(MM)] + [['Fond'] + MASS], ';', ',')
put('fractions.csv', rows_of(
    ['d (mm)', 'Feed fraction passing', 'Product 69 m/s fraction passing',
     'Product 79 m/s fraction passing'],
    [[round(p / 100, 4) for p in c] for c in CURVES]))
put('fraction-percent-asks.csv', rows_of(
    ['d (mm)', 'Feed passing %', 'Product 69 m/s passing %',
     'Product 79 m/s passing %'],
    [[round(p / 100, 4) for p in c] for c in CURVES]))
put('mm-and-um.csv', rows_of(
    ['Sieve', 'Feed', 'Product 69 m/s', 'Product 79 m/s'],
    sizes=['%g mm' % s if s >= 1 else '%g µm' % (s * 1000) for s in MM]))
put('sieves-um-under-mm-refused.csv', rows_of(
    ['Sieve (mm)', 'Feed', 'Product 69 m/s', 'Product 79 m/s'],
    sizes=[s if s >= 1 else s * 1000 for s in MM]))
put('timesheet-refused.csv', [
    ['Name', 'Mon', 'Tue', 'Wed'], ['Ann', 8, 8, 7.5], ['Bo', 8, 4, 8],
    ['Total', 16, 12, 15.5]])
put('prices-refused.csv', [
    ['Product', 'Size (mm)', 'EUR/t', 'Stock (t)'], ['0/2', 2, 14.5, 1200],
    ['2/5', 5, 12, 800], ['5/8', 8, 11.5, 650], ['8/11', 11.2, 11, 2100]])
put('envelope-refused.csv', [
    ['Sieve (mm)', 'Min passing (%)', 'Max passing (%)'], [8, 100, 100],
    [4, 95, 100], [2, 70, 95], [1, 45, 70], [0.5, 28, 50], [0.063, 3, 10]])
with open('awk.csv', 'w') as f:
    f.write(subprocess.run(
        ['awk', 'BEGIN { FS = ","; OFS = "\t" } !/^size/ '
         '{ printf "%g\\t%.1f\\t%.1f\\t%.1f\\n", $1, $2, $3, $4 } '
         '/^size/ { print "sieve_mm", "feed", "v69m/s", "v79m/s" }',
         'same.is'], capture_output=True, text=True).stdout)


# --- samples in lines, sizes as what passes them
put('rows-minus.csv', [['Test', 'Tip speed (m/s)', 'Density t/m3']
                       + ['-%g mm' % s for s in MM] + ['FM']]
    + [[n, v, 2.7] + c + [3.1] for n, v, c in
       zip(['Feed', 'T1', 'T2'], [None, 69, 79], CURVES)])

# --- samples in lines, their speeds at the end
put('rows-speed.csv', [['Sample'] + MM + ['Speed m/s']]
    + [[n] + c + [v] for n, v, c in
       zip(['Feed', 'P1', 'P2'], [None, 69, 79], CURVES)])

# --- a table that goes on on the next page, with its headings again
rows = rows_of(['mm', 'Feed', '69 m/s', '79 m/s'])
put('page-break.csv', [['Percent passing']] + rows[:8] + [[], ['Page 2 of 2']]
    + rows[:1] + rows[8:])

# --- tables of an instrument, one below the other, titles for samples
lines = []
for name, grams in zip(['Feed', 'Product 69 m/s', 'Product 79 m/s'], GRAMS):
    lines += [['Sample', name], ['mm', 'Mass [g]', '1-Q3 [%]']]
    lines += [[s, g, round(100 * sum(grams[:i + 1]) / sum(grams), 1)]
              for i, (s, g) in enumerate(zip(MM + ['Pan'], grams))] + [[]]
put('titles-print.csv', lines)

# --- files whose names state the speed
for name, curve in zip(['cut_69ms.csv', 'cut_79_m-s.csv'], CURVES[1:]):
    put(name, rows_of(['Sieve (mm)', 'Passing (%)'], [curve]))

# --- workbooks by openpyxl
def book(name, fill):
    wb = openpyxl.Workbook()
    fill(wb)
    path = name if name.endswith('.xlsx') and os.sep not in name else name
    wb.save(path)
    return path


def append(ws, rows):
    for r in rows:
        ws.append([None if c == '' else c for c in r])


def plain(wb):
    ws = wb.active
    ws.title = 'Maj'
    append(ws, [['Siktanalys, Önnestad'], ['Datum', DAY], []])
    append(ws, rows_of(HEADS_SV))
    for r in ws.iter_rows(min_row=5, min_col=2):
        for c in r:
            c.number_format = '0.0'


def lab(wb):
    """A laboratory's form: masses are typed, all else is computed."""
    ws = wb.active
    ws.title = 'Sieving'
    ws['A1'] = 'Sieve analysis EN 933-1'
    ws.merge_cells('A1:G1')
    append(ws, [['Site', 'Berga', '', 'Date', DAY], []])
    ws.append(['Sieve (mm)', 'Feed', None, 'Product 69 m/s', None,
               'Product 79 m/s', None])
    ws.append([None] + ['Retained (g)', 'Passing (%)'] * 3)
    for r in 'B4:C4', 'D4:E4', 'F4:G4':
        ws.merge_cells(r)
    for i, s in enumerate(MM + ['Pan']):
        r = 6 + i
        row = [s]
        for k in range(3):
            col = 'BDF'[k]
            row += [GRAMS[k][i], '=100*(1-SUM(%s$6:%s%d)/%s$19)' %
                    (col, col, r, col) if s != 'Pan' else None]
        ws.append(row)
    ws.append(['Total'] + [c for k in range(3) for c in
                           ('=SUM(%s6:%s18)' % ('BDF'[k], 'BDF'[k]), None)])
    for r in ws.iter_rows(min_row=6, max_row=19, min_col=2):
        for c in r:
            c.number_format = '#,##0.0'


def percent_format(wb):
    ws = wb.active
    append(ws, rows_of(['Sieve (mm)', 'Feed', 'Product 69 m/s',
                        'Product 79 m/s'],
                       [[round(p / 100, 4) for p in c] for c in CURVES]))
    for r in ws.iter_rows(min_row=2, min_col=2):
        for c in r:
            c.number_format = '0.0%'


def two_tabs(wb):
    ws = wb.active
    ws.title = 'May'
    append(ws, rows_of(HEADS_SV))
    ws = wb.create_sheet('June')
    append(ws, rows_of(HEADS_SV, JUNE))


def readme_tab(wb):
    ws = wb.active
    ws.title = 'Read me'
    append(ws, [['How to fill in the next sheet'], ['Ask Åsa for the form']])
    ws = wb.create_sheet('Data')
    append(ws, rows_of(HEADS_SV))
    ws = wb.create_sheet('Old')
    append(ws, rows_of(HEADS_SV, JUNE))
    ws.sheet_state = 'hidden'


def merged(wb):
    ws = wb.active
    append(ws, [['Maschenweite', 'Aufgabe', 'Produkt', ''],
                ['', '', '69 m/s', '79 m/s'],
                ['mm', 'Durchgang %', 'Durchgang %', 'Durchgang %']])
    append(ws, rows_of([])[1:])
    ws.merge_cells('A1:A2')
    ws.merge_cells('B1:B2')
    ws.merge_cells('C1:D1')
    ws['C1'].alignment = Alignment(horizontal='center')


def across(wb):
    ws = wb.active
    rows = turned(rows_of(['Sieve (mm)', 'Feed', 'Product 69 m/s',
                           'Product 79 m/s']))
    append(ws, [['Date' if i == 0 else DAY] + r for i, r in enumerate(rows)])


def tidy(wb):
    append(wb.active, LONG)


def speed_row(wb):
    ws = wb.active
    append(ws, [['Tip speed (m/s)', '', 69, 79],
                ['Sieve (mm)', 'Feed', 'Product', 'Product']])
    append(ws, rows_of([])[1:])


def as_text(wb):
    append(wb.active, [[text(c, ',') for c in r] for r in rows_of(HEADS_SV)])


def tab_each(wb):
    for i, (name, curve) in enumerate((('Feed', FEED), ('69 m/s'.replace(
            '/', ' per '), P69), ('79 m per s', P79))):
        ws = wb.active if i == 0 else wb.create_sheet()
        ws.title = name
        append(ws, [['Sample', 'Feed' if i == 0 else 'Product']] + (
            [['Tip speed (m/s)', (69, 79)[i - 1]]] if i else []))
        append(ws, rows_of(['Sieve (mm)', 'Passing (%)'], [curve]))


def rotor_tab(wb):
    """The rotor stands on a sheet without a table, the rpm in names."""
    append(wb.create_sheet('Info'), [['Rotor diameter', '900 mm']])
    for name, curve in zip(['Feed', '1464 rpm', '1676 rpm'], CURVES):
        append(wb.create_sheet(name), rows_of(['mm', '% passing'], [curve]))


def named_tabs(wb):
    """The names of sheets tell samples apart, and nothing states a speed."""
    for name, curve in zip(['Mating', 'Prov A', 'Prov B'], CURVES):
        append(wb.create_sheet(name), rows_of(['mm', 'Pass. %'], [curve]))


def chart_tab(wb):
    """Feed and products have sheets, and again one for their chart."""
    append(wb.create_sheet('Feed'), rows_of(['mm', '% passing'], [FEED]))
    head = ['mm', '69 m/s', '79 m/s']
    append(wb.create_sheet('Products'), rows_of(head, CURVES[1:]))
    append(wb.create_sheet('Chart data'), rows_of(
        ['log d', 'Feed'] + head[1:],
        sizes=[round(math.log10(s), 3) for s in MM]))


def range_of(wb):
    ws = wb.active
    append(ws, [['May']] + rows_of(HEADS_SV) + [[], ['June']] +
           rows_of(HEADS_SV, JUNE))


def date_sieves(wb):
    """3/8 typed into a spreadsheet becomes the 8th of March."""
    append(wb.active, rows_of(
        ['Sieve', 'Feed', 'Product 69 m/s', 'Product 79 m/s'],
        sizes=['7/8 in', datetime.date(2026, 5, 8), '7/16 in',
               datetime.date(2026, 5, 16)] + ASTM[4:]))


def summary(wb):
    """Figures beside the table, one of them broken."""
    ws = wb.active
    append(ws, rows_of(['Sieve (mm)', 'Feed', 'Product 69 m/s',
                        'Product 79 m/s']))
    for r, (k, v) in enumerate((('P80 feed (mm)', 10.1),
                                ('Reduction', '=F2/0'), ('By', 'Åsa')), 2):
        ws.cell(row=r, column=7, value=k)
        ws.cell(row=r, column=8, value=v)


for name, fill in (('openpyxl-plain', plain), ('habit-17', speed_row),
                   ('openpyxl-percent', percent_format),
                   ('openpyxl-tabs', two_tabs), ('openpyxl-readme', readme_tab),
                   ('openpyxl-merged', merged), ('openpyxl-across', across),
                   ('openpyxl-tidy', tidy), ('openpyxl-text', as_text),
                   ('openpyxl-cuts', tab_each), ('openpyxl-rotor', rotor_tab),
                   ('openpyxl-named', named_tabs),
                   ('openpyxl-chart', chart_tab),
                   ('openpyxl-range', range_of),
                   ('openpyxl-dates', date_sieves)):
    book(name + '.xlsx', fill)


# --- LibreOffice
def office(source, name, locale, kind, options=''):
    """Converts as LibreOffice does for somebody of that country."""
    out = tempfile.mkdtemp(dir=TMP)
    form = kind + ((':Text - txt - csv (StarCalc):' + options)
                   if options else '')
    subprocess.run(
        ['soffice', '-env:UserInstallation=file://%s/%s' % (TMP, locale),
         '--headless', '--convert-to', form, '--outdir', out, source],
        env=dict(os.environ, LC_ALL=locale + '.UTF-8',
                 LANG=locale + '.UTF-8'), check=True,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    made = os.path.join(out, os.path.splitext(os.path.basename(source))[0] +
                        '.' + kind)
    with zipfile.ZipFile(made) if kind == 'ods' else open(os.devnull) as old:
        if kind != 'ods':
            os.replace(made, name)
            return
        # A picture of the sheet is most of the file.
        with zipfile.ZipFile(name, 'w', zipfile.ZIP_DEFLATED) as new:
            for item in old.infolist():
                if not item.filename.startswith('Thumbnails/'):
                    new.writestr(item, old.read(item.filename))


BOOKS = {f.__name__: book(os.path.join(TMP, f.__name__ + '.xlsx'), f)
         for f in (plain, lab, percent_format, merged, across, speed_row,
                   summary, tidy)}
UTF8, SEMI, TAB, CP1252, UTF16 = ('44,34,76', '59,34,76', '9,34,76',
                                  '59,34,1', '9,34,65535')
office(BOOKS['plain'], 'habit-05.csv', 'sv_SE', 'csv')
office(BOOKS['plain'], 'habit-18.ods', 'sv_SE', 'ods')
for fill, locale, kind, options, extra in (
        ('plain', 'en_US', 'csv', UTF8, ''), ('plain', 'de_DE', 'csv', SEMI, ''),
        ('plain', 'fr_FR', 'csv', CP1252, ''), ('plain', 'fi_FI', 'csv', TAB, ''),
        ('plain', 'de_CH', 'csv', SEMI, ''), ('plain', 'sv_SE', 'csv', UTF16, '-utf16'),
        ('lab', 'en_US', 'csv', UTF8, ''), ('lab', 'de_DE', 'csv', SEMI, ''),
        ('lab', 'sv_SE', 'csv', SEMI, ''), ('lab', 'fr_FR', 'csv', SEMI, ''),
        ('lab', 'de_CH', 'csv', SEMI, ''), ('lab', 'pt_BR', 'csv', TAB, ''),
        ('lab', 'es_ES', 'csv', CP1252, ''), ('lab', 'en_US', 'xlsx', '', ''),
        ('lab', 'de_DE', 'ods', '', ''),
        ('percent_format', 'sv_SE', 'csv', SEMI, ''),
        ('percent_format', 'en_US', 'csv', UTF8, ''),
        ('percent_format', 'fr_FR', 'ods', '', ''),
        ('merged', 'de_DE', 'csv', SEMI, ''), ('merged', 'de_DE', 'ods', '', ''),
        ('across', 'en_GB', 'csv', UTF8, ''), ('across', 'es_ES', 'ods', '', ''),
        ('speed_row', 'pt_BR', 'csv', SEMI, ''),
        ('summary', 'en_US', 'xlsx', '', ''), ('summary', 'fi_FI', 'csv', SEMI, ''),
        ('tidy', 'fr_FR', 'csv', SEMI, '')):
    office(BOOKS[fill], 'office-%s-%s%s.%s' % (
        fill.replace('_format', '').replace('_', '-'), locale, extra, kind),
        locale, kind, options)


# --- gnumeric
def gnumeric(source, name, locale, exporter, *options):
    subprocess.run(['ssconvert', '-T', exporter, *options, source, name],
                   env=dict(os.environ, LC_ALL=locale + '.UTF-8'), check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


gnumeric(BOOKS['plain'], 'gnumeric-plain-en_US.csv', 'en_US',
         'Gnumeric_stf:stf_csv')
gnumeric(BOOKS['plain'], 'gnumeric-plain-de_DE.csv', 'de_DE',
         'Gnumeric_stf:stf_csv')
gnumeric(BOOKS['lab'], 'gnumeric-lab-sv_SE.txt', 'sv_SE',
         'Gnumeric_stf:stf_assistant', '-O',
         'separator=; format=preserve locale=sv_SE charset=ISO-8859-1')
gnumeric(BOOKS['lab'], 'gnumeric-lab.xlsx', 'en_US', 'Gnumeric_Excel:xlsx2')
gnumeric(BOOKS['merged'], 'gnumeric-merged.ods', 'en_US',
         'Gnumeric_OpenCalc:odf')
gnumeric(BOOKS['percent_format'], 'gnumeric-percent.ods', 'fr_FR',
         'Gnumeric_OpenCalc:odf')

# --- R
R = '''
d <- data.frame(sieve_mm = c(%s), feed = c(%s), product_69 = c(%s),
	product_79 = c(%s))
h <- c("Sieve mm", "Feed %%", "Product 69 m/s %%", "Product 79 m/s %%")
w <- setNames(d, h)
write.csv(w, "r-csv.csv", row.names = FALSE)
write.csv(w, "r-csv-rownames.csv")
write.csv2(w, "r-csv2.csv", row.names = FALSE)
write.csv(setNames(d, make.names(h)), "r-make-names.csv", row.names = FALSE)
write.table(w, "r-table.txt", sep = "\\t", quote = FALSE)
long <- rbind(data.frame(sample = "feed", speed_mps = NA, sieve_mm = d$sieve_mm,
	passing_pct = d$feed), data.frame(sample = "product", speed_mps = 69,
	sieve_mm = d$sieve_mm, passing_pct = d$product_69),
	data.frame(sample = "product", speed_mps = 79, sieve_mm = d$sieve_mm,
	passing_pct = d$product_79))
write.csv(long, "r-long.csv", row.names = FALSE)
write.csv2(long[order(long$sieve_mm), ], "r-long2.csv", row.names = FALSE)
''' % tuple(', '.join(map(str, c)) for c in [MM] + CURVES)
script = os.path.join(TMP, 'sheets.R')
with open(script, 'w') as f:
    f.write(R)
subprocess.run(['Rscript', script], check=True)

# --- what they were made by
with open('MADE-BY', 'w') as f:
    for command in (['soffice', '--version'], ['ssconvert', '--version'],
                    ['Rscript', '--version']):
        p = subprocess.run(command, capture_output=True, text=True)
        f.write((p.stdout + p.stderr).strip().split('\n')[0] + '\n')
    f.write('openpyxl %s\n' % openpyxl.__version__)
