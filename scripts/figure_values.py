# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""From the rows of the benchmarks to figures by key, such as core/ours_avx2/ns."""
from statistics import median

OURS = 'ours_avx2'


def flat(rows, template, **columns):
    """{key: value} of some columns; the key is the template, filled with the row, and a name."""
    return {'/'.join(filter(None, (template.format(**row), name.strip('_')))).replace(' ', '_'):
            row[column] for row in rows for name, column in columns.items() if column in row}


def of_core(rows):
    robots = [row for row in rows if row['kind'] == 'robot']
    ours = {row['mesh']: row['ns'] for row in rows if row['method'] == OURS}
    builds = [row for row in rows if row['method'] == 'build']
    build_ms = [row['ns'] / 1e6 for row in builds if row['kind'] == 'robot']
    figures = {
        'core/meshes': len({row['mesh'] for row in robots}),
        'core/large_hulls/ns': max(row['ns'] for row in rows if row['method'] == OURS and
                                   row['hull'] > 1500 and not row['mesh'].startswith('links:')),
        'core/build/median_ms': median(build_ms), 'core/build/max_ms': max(build_ms),
        'core/build/dragon_ms': next(row['ns'] / 1e6 for row in builds
                                     if row['mesh'].endswith('dragon_vrip_res2.ply')),
        'core/tables/median_kib': median(row['bytes'] / 1024 for row in builds
                                         if row['kind'] == 'robot')}
    for method in {row['method'] for row in robots} - {'build'}:
        own = [row for row in robots if row['method'] == method]
        volumes = [row['volume_ratio'] for row in own]
        figures.update({'core/%s/%s' % (method, name): value for name, value in {
            'ns': median(row['ns'] for row in own), 'volume': median(volumes),
            'times': median(row['ns'] / ours[row['mesh']] for row in own),
            'max_volume': max(volumes)}.items()})
    figures['core/price/ns'] = figures['core/%s/ns' % OURS] - figures['core/corners8/ns']
    figures.update(('core/links/%s/%s' % tuple(row['mesh'].split(':')[1:]), row['ns'])
                   for row in rows if row['mesh'].startswith('links:'))
    return figures


def of_cold_core(rows):
    robots = [row for row in rows if row['kind'] == 'robot']
    ns = {method: median(row['ns'] for row in robots if row['method'] == method)
          for method in {row['method'] for row in robots}}
    return {'core_cold/code_percent': 100 * (1 - ns[OURS + '_warm_code'] / ns[OURS]),
            **{'core_cold/%s/ns' % method: value for method, value in ns.items()}}


def of_pipeline(rows):
    times = {(row['links'], row['depth'], row['method']): row['ns_per_link'] for row in rows}
    figures = flat(rows, 'pipeline/{links}/{depth}/{method}', _='ns_per_link')
    for rival in ('time_cache', 'buffer_core', 'usual_tf2'):
        ratios = [times[links, depth, rival] / ns for (links, depth, method), ns in times.items()
                  if method == 'ours' and (links in (50, 200) or rival == 'usual_tf2')]
        figures.update({'pipeline/%s/min' % rival: min(ratios),
                        'pipeline/%s/max' % rival: max(ratios)})
    update = times[200, 10, 'ours'] - times[200, 10, 'relay']
    return {**figures, 'pipeline/above_relay_us': 200 * update / 1e3}


def of_cold_pipeline(rows):
    stages = [dict(row, stage=row['stage'].replace('~', '')) for row in rows if 'stage' in row]
    figures = flat([row for row in rows if 'method' in row], 'cold/{links}/{method}',
                   _='ns_per_link')
    names = ('percent', 'code_lines', 'data_lines')
    figures.update(flat(stages, 'cold/{links}/{stage}', **dict(zip(names, names))))
    for links in {row['links'] for row in stages if 'code_lines' in row}:
        figures.update(('cold/%d/%s' % (links, name), sum(
            row[name] for row in stages if row['links'] == links)) for name in names[1:])
    return figures


def of_end_to_end(rows):
    figures = flat(rows, 'end_to_end/{links}/{hz}/{method}', p50='p50_us', p90='p90_us',
                   p99='p99_us', cpu_us_per_update='cpu_us_per_update', cpu_min='cpu_min',
                   cpu_max='cpu_max', repetitions='repetitions', bytes='bytes')
    figures.update((key + '_ms', value / 1e3) for key, value in list(figures.items())
                   if key.endswith('p50'))
    parts = (('above_relay', 'ours', 'relay'), ('intake', 'ours_one_link', 'relay'),
             ('links', 'ours_spheres', 'ours_one_link'), ('tables', 'ours', 'ours_spheres'))
    for hz in {row['hz'] for row in rows if row['method'] == 'ours_spheres'}:
        cpu = 'end_to_end/200/%d/%%s/cpu_us_per_update' % hz
        figures.update(('end_to_end/200/%d/%s' % (hz, name), figures[cpu % more] -
                        figures[cpu % less]) for name, more, less in parts)
        figures.update(('end_to_end/' + count, sum(
            row[count] for row in rows if row['method'] == 'ours')) for count in (
                'sent', 'received'))
    return figures


def of_objects(rows):
    times = {(row['method'], row['type'], row['points']): row['ns_per_point'] for row in rows}
    return {'objects/unmapping_ns': median(
        times['ours', kind, points] - times['ours_kept', kind, points]
        for method, kind, points in times if (method, points) == ('ours', 99999))}


def of_many_objects(rows):
    return {'objects/' + name: row[name] for row, names in zip(rows, (
        ('core_percent', 'p50_ms'), ('resident_mb', 'kept_mb'))) for name in names}


def of_overlaps(rows):
    times = {count: [row['us_per_step'] / 1e3 for row in rows if row['method'] == 'ours' and
                     row['boxes'] == count] for count in {row['boxes'] for row in rows}}
    return {'overlaps/%d/%s_ms' % (count, name): end(own) for count, own in times.items()
            for name, end in (('min', min), ('max', max))}


def of_distances(rows):
    names = {'fcl BVH': 'fcl', 'bullet convex': 'bullet'}
    ends = {'update': '{level}', 'generated': '{method}/{triangles}'}
    figures = {}
    for row in rows:
        us = row['us_per_update'] if row['which'] == 'update' else row['ns_per_pair'] / 1e3
        row = dict(row, method=names.get(row['method'], row['method']), us=us)
        end = ends.get(row['which'], '{method}/{level}')
        figures.update(flat([row], 'distances/{robot}/{motion}/{which}/' + end, _='us'))
    return figures


def of_parts(rows):
    whole = {row['model']: row for row in rows if row['parts_per_link'] == 1}
    return {'parts/%s/%d/%s' % (row['model'], row['parts_per_link'], name):
            row[column] / whole[row['model']][column]
            for row in rows for name, column in (('rest', 'volume'), ('turned', 'turned_volume'))}


def of_start_up(rows):
    names = ('resident_mb', 'peak_mb', 'tables_mb', 'files', 'loading_mb')
    rows = [dict(row, seconds=row['median_ms'] / 1e3) for row in rows]
    return flat(rows, 'start_up/{robot}', seconds='seconds', **dict(zip(names, names)))


def of_volumes(rows):
    links = {row['mesh']: row['vertices'] for row in rows}
    figures = {'volumes/robots': len(links), 'volumes/links': sum(links.values())}
    figures.update(flat([row for row in rows if row['volume_ratio'] is not None],
                        'volumes/{mesh}/{method}', _='volume_ratio'))
    for method in {row['method'] for row in rows}:
        for name, column, unit in (('volume', 'volume_ratio', 1), ('ns', 'ns', 1),
                                   ('ms', 'ns', 1e6)):
            own = [row for row in rows if row['method'] == method and row[column] is not None]
            if own:
                figures['volumes/%s/%s' % (method, name)] = (
                    sum(row[column] * links[row['mesh']] for row in own) / unit /
                    sum(links[row['mesh']] for row in own))
    return figures


def of_bag(rows):
    """The other kinds of rows, of several bags or threads at once, only have targets."""
    rows = [dict(row, reader=row['reader'].replace(' --', '_')) for row in rows
            if row['kind'] in ('speed', 'memory')]
    rows = [dict(row, short=row['peaks_mb'][0], long=row['peaks_mb'][1]) if row['kind'] == 'memory'
            else dict(row, ratio=median(row['ratios']), speed=median(row['times_real_time']))
            for row in rows]
    return flat(rows, 'bag/{reader}', short_mb='short', long_mb='long', seconds='median_s',
                ratio='ratio', real_time='speed')


def of_get_boxes(rows):
    return flat([dict(row, call=row['call'].replace(', ', '_')) for row in rows],
                'get_boxes/{call}', us='p50_us')


def of_swept(rows):
    return flat(rows, 'swept/{span:g}', ms='swept_ms', sampled_ms='sampled_ms')


def of_proofs(rows):
    """With a larger budget than was needed, as many pairs are decided as with the largest one."""
    rows = [dict(row, robot=row.get('robot', '').replace(', ', '_')) for row in rows]
    figures = flat([row for row in rows if row['proof'] == 'reach'],
                   'proofs/reach/{robot}/{accuracy:g}', s='seconds')
    for row in rows:
        if row['proof'] != 'pairs':
            continue
        decided = row['pairs'] - row['UNDECIDED']
        own = {'pairs': row['pairs'], 'wrong': len(row.get('wrong_never', []))}
        for budget in (0.1, 0.3, 1, 3, 10, 120):
            if budget >= row['budget']:
                own.update({'%g/decided' % budget: decided,
                            '%g/percent' % budget: 100 * decided / row['pairs']})
        key = 'proofs/pairs/%s/' % row['robot'].replace(' ', '_')
        figures.update((key + name, value) for name, value in own.items())
    return figures


PARTS = {'bag': of_bag, 'core': of_core, 'core --cold': of_cold_core, 'pipeline': of_pipeline,
         'pipeline --cold': of_cold_pipeline, 'end-to-end': of_end_to_end,
         'end-to-end --links 50 1000': of_end_to_end, 'get-boxes': of_get_boxes,
         'objects': of_objects, 'many-objects': of_many_objects, 'overlaps': of_overlaps,
         'distances': of_distances, 'parts': of_parts, 'proofs': of_proofs,
         'start-up': of_start_up, 'swept': of_swept, 'volumes': of_volumes}
