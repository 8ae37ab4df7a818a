# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""From the rows of the benchmarks to figures by key, such as core/ours_avx2/ns."""
import re
from statistics import median

TARGET = re.compile(r'^(.+?) +(>=|<=) +([\d.]+): +(-?[\d.]+) +(reached|MISSED) +'
                    r'\(from (-?[\d.]+) to (-?[\d.]+) (?:on|in) (\d+) \w+\)$')
OURS = 'ours_avx2'


def targets_of(output):
    """What a benchmark prints of its targets. A line that looks like one must be one."""
    targets = []
    for line in output.splitlines():
        if not re.search(r'(reached|MISSED) +\(from ', line):
            continue
        found = TARGET.match(line)
        if not found:
            raise LookupError('this line of a target cannot be read: ' + line)
        text, wanted, limit, value, verdict, low, high, count = found.groups()
        targets.append({
            'target': text, 'wanted': wanted, 'limit': float(limit), 'median': float(value),
            'reached': verdict == 'reached', 'min': float(low), 'max': float(high),
            'count': int(count)})
    return targets


def shortfall(target):
    """By how much a target is missed, as a part of its limit; 0 or less if it is reached."""
    ratio = target['median'] / target['limit']
    return 1 - ratio if target['wanted'] == '>=' else ratio - 1


def summary(targets, start):
    """The figures of all targets whose text begins so. Several are one row: the range of medians,
    the range of all, and the worst verdict."""
    chosen = [target for target in targets if target['target'].startswith(start)]
    if not chosen:
        return {}
    medians = sorted(target['median'] for target in chosen)
    worst = max(shortfall(target) for target in chosen)
    return {'limit': chosen[0]['limit'], 'from': medians[0], 'to': medians[-1],
            'min': min(target['min'] for target in chosen),
            'max': max(target['max'] for target in chosen), 'count': chosen[0]['count'],
            'verdict': 'reached' if worst <= 0 else '**missed by %.0f %%**' % max(1, 100 * worst)}


# The rows of the table of targets, by the beginning of what the benchmarks print.
TARGETS = {
    'paper_loop': 'paper_loop / ', 'bullet_slow': 'bullet_slow / ', 'fcl_exact': 'fcl_exact / ',
    'geometric_shapes': OURS + ' / geometric_shapes', 'sse2': 'ours_sse2 / corners8',
    'avx2': 'ours_avx2 / corners8', 'unchanged': 'ours_unchanged / eigen',
    'dragon': OURS + ', dragon of 100,000 vertices',
    'links': OURS + ', per link, 1000 links / 50 links, 16 meshes',
    'distinct': OURS + ', per link, 1000 links / 50 links, distinct meshes',
    'cold_corners8': 'cold: ' + OURS + ' / corners8',
    'deserialize': 'ours / deserialize', 'usual_tf2': 'usual_tf2 / ours',
    'cold_deserialize': 'cold: ours / deserialize', 'cold_usual_tf2': 'cold: usual_tf2 / ours',
    'growth': 'ours per link, 1000 links', 'points': 'ours, 100,000 points / 10,000 points',
    'minmax': 'ours / minmax', 'kept_points': 'ours_kept, 100,000 points / 10,000 points',
    'kept_minmax': 'ours_kept / minmax', 'overlaps_1000': 'overlaps / faster peer, 1000 boxes  ',
    'overlaps_10000': 'overlaps / faster peer, 10000 boxes  ',
    'slowest_1000': 'overlaps / faster peer, 1000 boxes, slowest',
    'slowest_10000': 'overlaps / faster peer, 10000 boxes, slowest',
    'distance_near': 'fcl BVH / ours, mesh level, pairs within 0.1 m  ',
    'distance_all': 'fcl BVH / ours, mesh level, all pairs',
    'distance_worst': 'fcl BVH / ours, mesh level, pairs within 0.1 m, worst',
    'distance_random': 'us per pair, hull level, random',
    'distance_coherent': 'us per pair, hull level, coherent',
    'distance_panda': 'us per update, mesh level, all pairs of the panda',
    'distance_pr2': 'us per update, mesh level, all pairs of the pr2',
    'distance_growth': 'us per pair, hull level, longest', 'distance_bytes': 'bytes per triangle',
    'cpu_50': 'us above the relay, 50 links at 100 Hz',
    'cpu_200': 'us above the relay, 200 links at 100 Hz',
    'cpu_1000': 'us above the relay, 1000 links at 100 Hz',
    'slow_50': 'p50, ours / relay, medians, 50 links at 100 Hz',
    'slow_200': 'p50, ours / relay, medians, 200 links at 100 Hz',
    'slow_1000': 'p50, ours / relay, medians, 1000 links at 100 Hz',
    'fast_medians': 'p50, ours / relay, medians, 200 links at 1000 Hz',
    'with_distances': 'p50, ours with ~distances / without',
    'relay': 'p50, ours / relay, 200 links at 1000 Hz  ', 'usual_tf2_p50': 'p50, ours / usual_tf2',
    'answered': 'answered / sent',
    'bag_real_time': 'bag_bounds, times real time', 'bag_rosbag': 'bag_bounds / rosbag',
    'bag_memory': 'bag_bounds, memory', 'bag_out_memory': 'bag_bounds --out, memory',
    'past_latest': 'p50, ~get_boxes / an empty service, latest  ',
    'past_recent': 'p50, ~get_boxes / an empty service, 0.1 s ago',
    'past_old': 'p50, ~get_boxes / an empty service, 2 s ago',
    'past_fresh': 'p50, ~get_boxes / an empty service, latest, fresh',
    'reach': 'seconds of --reach to 1 cm', 'pairs': '% of pairs that --pairs decides'}


def of_targets(targets):
    padded = [dict(target, target=target['target'] + '  ') for target in targets]
    return {'targets/%s/%s' % (name, figure): value for name, start in TARGETS.items()
            for figure, value in summary(padded, start).items()}


def of_core(rows):
    robots = [row for row in rows if row['kind'] == 'robot']
    times = {(row['mesh'], row['method']): row['ns'] for row in rows}
    figures = {'core/meshes': len({row['mesh'] for row in robots})}
    for method in sorted({row['method'] for row in robots} - {'build'}):
        own = [row for row in robots if row['method'] == method]
        key = 'core/%s/' % method
        figures[key + 'ns'] = median(row['ns'] for row in own)
        figures[key + 'times'] = median(row['ns'] / times[row['mesh'], OURS] for row in own)
        ratios = [row['volume_ratio'] for row in own]
        figures[key + 'volume'] = median(ratios)
        figures[key + 'max_volume'] = max(ratios)
    for row in rows:
        if row['mesh'].startswith('links:'):
            _, count, meshes = row['mesh'].split(':')
            figures['core/links/%s/%s' % (count, meshes)] = row['ns']
    large = [row['ns'] for row in rows if row['method'] == OURS and row['hull'] > 1500
             and not row['mesh'].startswith('links:')]
    figures['core/large_hulls/ns'] = max(large)
    loose = figures['core/corners8/ns']
    figures['core/price/ns'] = figures['core/%s/ns' % OURS] - loose
    builds = {row['mesh']: row for row in rows if row['method'] == 'build'}
    of_robots = [row['ns'] / 1e6 for row in builds.values() if row['kind'] == 'robot']
    figures['core/build/median_ms'] = median(of_robots)
    figures['core/build/max_ms'] = max(of_robots)
    figures['core/build/dragon_ms'] = next(
        row['ns'] / 1e6 for mesh, row in builds.items() if mesh.endswith('dragon_vrip_res2.ply'))
    tables = [row['bytes'] / 1024 for row in builds.values() if row['kind'] == 'robot']
    figures['core/tables/median_kib'] = median(tables)
    figures['core/tables/max_kib'] = max(tables)
    return figures


def of_cold_core(rows):
    robots = [row for row in rows if row['kind'] == 'robot']
    figures = {'core_cold/%s/ns' % method: median(row['ns'] for row in robots
                                                  if row['method'] == method)
               for method in {row['method'] for row in robots}}
    figures['core_cold/code_percent'] = 100 * (
        1 - figures['core_cold/%s_warm_code/ns' % OURS] / figures['core_cold/%s/ns' % OURS])
    return figures


def of_pipeline(rows):
    times = {(row['links'], row['depth'], row['method']): row['ns_per_link'] for row in rows}
    figures = {'pipeline/%d/%d/%s' % key: ns for key, ns in times.items()}
    for rival in ('time_cache', 'buffer_core', 'usual_tf2', 'deserialize'):
        ratios = [times[links, depth, rival] / ns for (links, depth, method), ns in times.items()
                  if method == 'ours' and (links in (50, 200) or rival == 'usual_tf2')]
        figures.update({'pipeline/%s/min' % rival: min(ratios),
                        'pipeline/%s/max' % rival: max(ratios)})
    update = times[200, 10, 'ours'] - times[200, 10, 'relay']
    figures['pipeline/above_relay_us'] = 200 * update / 1e3
    return figures


def of_cold_pipeline(rows):
    figures = {'cold/%d/%s' % (row['links'], row['method']): row['ns_per_link']
               for row in rows if 'method' in row}
    for row in rows:
        if 'code_lines' in row:
            key = 'cold/%d/%s/' % (row['links'], row['stage'].replace(' ', '_').replace('~', ''))
            figures.update({key + name: row[name] for name in (
                'percent', 'code_lines', 'data_lines')})
            for name in ('code_lines', 'data_lines'):
                key = 'cold/%d/%s' % (row['links'], name)
                figures[key] = figures.get(key, 0) + row[name]
    return figures


def of_end_to_end(rows):
    figures = {'end_to_end/' + count: sum(row[count] for row in rows if row['method'] == 'ours')
               for count in ('sent', 'received')}
    for row in rows:
        key = 'end_to_end/%d/%d/%s/' % (row['links'], row['hz'], row['method'])
        figures.update({key + 'p50': row['p50_us'], key + 'p90': row['p90_us'],
                        key + 'p99': row['p99_us'], key + 'p50_ms': row['p50_us'] / 1e3,
                        key + 'cpu_us_per_update': row['cpu_us_per_update']})
    for links, hz in {(row['links'], row['hz']) for row in rows if row['links'] == 200}:
        key = 'end_to_end/%d/%d/' % (links, hz)
        for method in ('ours', 'usual_tf2'):
            above = (figures['%s%s/cpu_us_per_update' % (key, method)] -
                     figures[key + 'relay/cpu_us_per_update'])
            figures['%s%s/ns_per_link' % (key, method)] = 1e3 * above / links
        cpu = {method: figures['%s%s/cpu_us_per_update' % (key, method)]
               for method in ('relay', 'ours_one_link', 'ours_spheres', 'ours')}
        figures.update({key + 'above_relay': cpu['ours'] - cpu['relay'],
                        key + 'intake': cpu['ours_one_link'] - cpu['relay'],
                        key + 'links': cpu['ours_spheres'] - cpu['ours_one_link'],
                        key + 'tables': cpu['ours'] - cpu['ours_spheres']})
    return figures


def of_objects(rows):
    times = {(row['method'], row['type'], row['points']): row['ns_per_point'] for row in rows}
    return {'objects/unmapping_ns': median(
        times['ours', kind, points] - times['ours_kept', kind, points]
        for method, kind, points in times if (method, points) == ('ours', 99999))}


def of_many_objects(rows):
    moving, many = rows
    return {'objects/core_percent': moving['core_percent'], 'objects/p50_ms': moving['p50_ms'],
            'objects/resident_mb': many['resident_mb'], 'objects/kept_mb': many['kept_mb']}


def of_overlaps(rows):
    figures = {}
    for count in sorted({row['boxes'] for row in rows}):
        times = [row['us_per_step'] / 1e3 for row in rows
                 if row['method'] == 'ours' and row['boxes'] == count]
        figures.update({'overlaps/%d/min_ms' % count: min(times),
                        'overlaps/%d/max_ms' % count: max(times)})
    return figures


def of_distances(rows):
    figures = {}
    for row in rows:
        robot, motion = row['robot'].replace(' ', '_'), row['motion']
        method = {'fcl BVH': 'fcl', 'bullet convex': 'bullet'}.get(row['method'], row['method'])
        key = 'distances/%s/%s/%s/' % (robot, motion, row['which'])
        if row['which'] == 'update':
            figures['%s%s' % (key, row['level'])] = row['us_per_update']
        elif row['which'] == 'generated':
            figures['%s%s/%d' % (key, method, row['triangles'])] = row['ns_per_pair'] / 1e3
        else:
            figures['%s%s/%s' % (key, method, row['level'])] = row['ns_per_pair'] / 1e3
    return figures


def of_parts(rows):
    whole = {row['model']: row for row in rows if row['parts_per_link'] == 1}
    return {'parts/%s/%d/%s' % (row['model'], row['parts_per_link'], name):
            row[column] / whole[row['model']][column]
            for row in rows for name, column in (('rest', 'volume'), ('turned', 'turned_volume'))}


def of_start_up(rows):
    figures = {}
    for row in rows:
        key = 'start_up/%s/' % row['robot']
        figures[key + 'seconds'] = row['median_ms'] / 1e3
        for name in ('resident_mb', 'peak_mb', 'tables_mb', 'files', 'loading_mb'):
            figures[key + name] = row[name]
    return figures


def of_volumes(rows):
    robots = {row['mesh']: row['vertices'] for row in rows}
    figures = {'volumes/robots': len(robots), 'volumes/links': sum(robots.values())}

    def average(method, column):
        own = [row for row in rows if row['method'] == method and row[column] is not None]
        return (sum(row[column] * robots[row['mesh']] for row in own) /
                sum(robots[row['mesh']] for row in own))
    for method in ('aabb', 'aabb_joints', 'sphere', 'obb'):
        figures['volumes/%s/volume' % method] = average(method, 'volume_ratio')
        if method != 'aabb_joints':
            figures['volumes/%s/ns' % method] = average(method, 'ns')
    for method in ('sphere_once', 'obb_once'):
        figures['volumes/%s/ms' % method] = average(method, 'ns') / 1e6
    for method in ('aabb_overlap', 'sphere_overlap'):
        figures['volumes/%s/ns' % method] = average(method, 'ns')
    for row in rows:
        if row['volume_ratio'] is not None:
            figures['volumes/%s/%s' % (row['mesh'], row['method'])] = row['volume_ratio']
    return figures


def of_bag(rows):
    figures = {}
    for row in rows:
        key = 'bag/%s/' % row['reader'].replace(' --', '_')
        if row['kind'] == 'memory':
            figures[key + 'short_mb'], figures[key + 'long_mb'] = row['peaks_mb']
        else:
            figures.update({key + 'seconds': row['median_s'], key + 'ratio': median(row['ratios']),
                            key + 'real_time': median(row['times_real_time'])})
    return figures


def of_get_boxes(rows):
    return {'get_boxes/%s/us' % row['call'].replace(', ', '_').replace(' ', '_'): row['p50_us']
            for row in rows}


def of_swept(rows):
    return {'swept/%g/%s' % (row['span'], name): row[column] for row in rows
            for name, column in (('ms', 'swept_ms'), ('sampled_ms', 'sampled_ms'))}


def of_proofs(rows):
    """With a larger budget than was needed, as many pairs are decided as with the largest one."""
    figures = {}
    for row in rows:
        if row['proof'] == 'gap':
            figures['proofs/gap/s'] = row['seconds']
            continue
        if row['proof'] == 'memory':
            figures['proofs/memory/MB'] = row['megabytes']
            continue
        key = 'proofs/%s/%s/' % (row['proof'], row['robot'].replace(', ', '_').replace(' ', '_'))
        if row['proof'] == 'reach':
            figures['%s%g/s' % (key, row['accuracy'])] = row['seconds']
            continue
        figures[key + 'pairs'] = row['pairs']
        figures[key + 'wrong'] = len(row.get('wrong_never', []))
        for budget in (0.1, 0.3, 1, 3, 10, 120):
            if budget >= row['budget']:
                decided = row['pairs'] - row['UNDECIDED']
                figures['%s%g/decided' % (key, budget)] = decided
                figures['%s%g/percent' % (key, budget)] = 100 * decided / row['pairs']
    return figures


PARTS = {'bag': of_bag, 'core': of_core, 'core --cold': of_cold_core, 'pipeline': of_pipeline,
         'pipeline --cold': of_cold_pipeline, 'end-to-end': of_end_to_end,
         'get-boxes': of_get_boxes, 'objects': of_objects, 'many-objects': of_many_objects,
         'overlaps': of_overlaps, 'distances': of_distances, 'parts': of_parts,
         'proofs': of_proofs, 'start-up': of_start_up, 'swept': of_swept, 'volumes': of_volumes}
