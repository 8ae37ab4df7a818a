#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes of doc/deployment.md for many bags on many machines: GNU parallel here and over ssh on
two further hosts, and a Slurm array. Each is killed in the middle and started again, and gives the lines
that one machine gives. The hosts are network namespaces, and share this machine's files.

scripts/machines installs what it needs, and runs it: many_machines_test.py PATH_OF_bag_bounds
"""
import contextlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

import bag_bounds_testing
from bag_bounds_testing import main
from bounds_testing import wait_for
from each_bag_test import EachBagTest
from page_testing import code_block
from patience import PATIENCE
from three_hosts_testing import SUBNET, hosts, unshare_command

PAGE = 'doc/deployment.md'
DEADLINE = 120 * PATIENCE  # s
INSIDE = 'LINK_BOUNDS_HOSTS'  # set where hosts can be made
SSHD = '/usr/sbin/sshd'
SLURM = '''
ClusterName=test
SlurmctldHost={name}({address})
AuthType=auth/munge
AuthInfo=socket={folder}/munge.sock
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
NodeName={name} NodeAddr={address} CPUs={cpus} State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP
'''


def needs(*programs):
    missing = [program for program in programs if not shutil.which(program)]
    return unittest.skipIf(missing, 'skipped: not installed: %s; scripts/machines installs them'
                           % ' '.join(missing))


class RecipeTest(EachBagTest):
    """In a folder with the bags, and the robot as robot.urdf."""

    @classmethod
    def setUpClass(cls):
        cls.hosts = hosts(3)

    @classmethod
    def tearDownClass(cls):
        for host in cls.hosts:
            host.end()
        subprocess.run(['ip', 'link', 'delete', 'switch'], check=True)

    def setUp(self):
        super().setUp()
        self.some_bags()
        for number in range(4):
            self.long_bag('run_%d_long.bag' % number)
        os.rename(self.urdf, self.path('robot.urdf'))
        self.bags = sorted(path.name for path in pathlib.Path(self.folder).glob('*.bag'))
        done = self.shell('%s --each *.bag --urdf robot.urdf --distances 0.05'
                          % bag_bounds_testing.BAG_BOUNDS)
        self.expected = sorted(done.stdout.splitlines())
        self.assertEqual([json.loads(line)['bag'] for line in self.expected], self.bags)

    @staticmethod
    def recipe(title):
        text = code_block(PAGE, title, 'bash').replace('10.0.0.', SUBNET)
        return text.replace('rosrun link_bounds bag_bounds', bag_bounds_testing.BAG_BOUNDS)

    def start(self, command):
        return self.hosts[0].start('bash', '-c', command, cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, encoding='utf-8')

    def shell(self, command):
        process = self.start(command)
        out, err = process.communicate(timeout=DEADLINE)
        return subprocess.CompletedProcess(command, process.returncode, out, err)

    def readers(self, host):
        """Processes of bag_bounds on a host that read bags of the folder."""
        network = os.readlink('/proc/%d/ns/net' % host._keeper.pid)
        found = []
        for process in pathlib.Path('/proc').glob('[0-9]*'):
            with contextlib.suppress(OSError):
                if (os.readlink(process / 'ns/net') == network and
                        (process / 'comm').read_text() == 'bag_bounds\n'):
                    found.append(int(process.name))
        return found

    def kill_one(self, host):
        wait_for(lambda: self.readers(host), 'bag_bounds on ' + host.address, DEADLINE)
        with contextlib.suppress(ProcessLookupError):
            os.kill(min(self.readers(host)), signal.SIGKILL)

    def found(self, pattern='lines*.jsonl'):
        return sorted({line for path in pathlib.Path(self.folder).glob(pattern)
                       for line in path.read_text('utf-8').splitlines()
                       if json.loads(line)['verdict'] != 'DIED'})

    def check_lines(self, files):
        self.assertEqual(self.found(), self.expected)
        done = self.shell('%s --merge %s --format json' % (bag_bounds_testing.BAG_BOUNDS, files))
        self.assertEqual(json.loads(done.stdout)['bags'],
                         [json.loads(line) for line in self.expected], done.stderr)

    def check_killed(self, command, host):
        """Started, a worker killed, started again: nothing is missing or read twice."""
        process = self.start(command)
        try:
            self.kill_one(host)
            process.communicate(timeout=DEADLINE)
        finally:
            process.kill()
        partly = self.found()
        self.assertLess(len(partly), len(self.expected))
        self.assertLessEqual(set(partly), set(self.expected))
        begin = time.monotonic()
        done = self.shell(command)
        print('%d lines after the kill, %d after the second start, which took %.1f s' % (
            len(partly), len(self.found()), time.monotonic() - begin))
        self.assertIn('bags have a line already', done.stderr)
        self.check_lines('lines.jsonl')

    @needs('parallel')
    def test_parallel(self):
        self.check_killed(self.recipe('### GNU parallel'), self.hosts[0])

    @needs('parallel', 'ssh', SSHD)
    def test_parallel_over_ssh(self):
        key, config = self.path('key'), self.path('ssh_config')
        subprocess.run(['ssh-keygen', '-q', '-t', 'ed25519', '-N', '', '-f', key], check=True)
        self.write('ssh_config', 'IdentityFile %s\nStrictHostKeyChecking no\nLogLevel ERROR\n'
                   'UserKnownHostsFile /dev/null\n' % key)
        os.makedirs('/run/sshd', exist_ok=True)
        for host in self.hosts[1:]:
            daemon = host.start(
                SSHD, '-D', '-f', '/dev/null', '-h', key, '-o', 'AuthorizedKeysFile=%s.pub' % key,
                '-o', 'StrictModes=no', '-o', 'PidFile=none', '-o', 'ListenAddress=' + host.address)
            self.addCleanup(daemon.wait)
            self.addCleanup(daemon.kill)
            ssh = 'ssh -F %s %s true' % (config, host.address)
            wait_for(lambda: self.shell(ssh).returncode == 0, 'sshd on ' + host.address, DEADLINE)
        command = 'export PARALLEL_SSH="ssh -F %s" PARALLEL_HOME=%s\n' % (config, self.folder)
        command += self.recipe('### Over ssh')
        self.check_killed(command, self.hosts[1])
        self.assertEqual(self.readers(self.hosts[1]) + self.readers(self.hosts[2]), [])

    @contextlib.contextmanager
    def slurm(self):
        """A cluster of one node, whose commands work here."""
        folder, name = self.path('slurm'), os.uname().nodename.split('.')[0]
        for each in ('state', 'spool'):
            os.makedirs(os.path.join(folder, each))
        os.chmod(self.folder, 0o755)  # munged insists
        key = pathlib.Path(folder, 'munge.key')
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        config = pathlib.Path(folder, 'slurm.conf')
        config.write_text(SLURM.format(name=name, address=self.hosts[0].address, folder=folder,
                                       cpus=os.cpu_count()), 'utf-8')
        os.environ['SLURM_CONF'] = str(config)
        quiet = {'stdout': subprocess.DEVNULL, 'stderr': subprocess.DEVNULL}
        daemons = [self.hosts[0].start(
            'munged', '--foreground', '--force', '--socket=%s/munge.sock' % folder,
            '--key-file=%s' % key, *('--%s-file=%s/munge.%s' % (kind, folder, kind)
                                     for kind in ('pid', 'log', 'seed')), **quiet)]
        try:
            wait_for(lambda: os.path.exists(folder + '/munge.sock'), 'munged', DEADLINE)
            for program in ('slurmctld', 'slurmd'):
                daemons.append(self.hosts[0].start(program, '-D', **quiet))
            wait_for(lambda: 'idle' in self.shell('sinfo --noheader --format %T').stdout,
                     'an idle node of Slurm', DEADLINE)
            yield
        finally:
            del os.environ['SLURM_CONF']
            for daemon in reversed(daemons):
                daemon.terminate()
                daemon.wait(DEADLINE)

    def test_a_task_of_slurm_without_a_bag(self):
        self.write('job.sh', self.recipe('### Slurm'))
        done = self.shell('SLURM_ARRAY_TASK_ID=99 SLURM_ARRAY_TASK_COUNT=100 bash job.sh')
        self.assertEqual((done.returncode, done.stderr, self.found()), (0, '', []))

    @needs('sbatch', 'slurmctld', 'slurmd', 'munged')
    def test_slurm(self):
        self.write('job.sh', self.recipe('### Slurm'))
        with self.slurm():
            self.assertIn('Submitted batch job', self.shell('sbatch job.sh').stdout)
            self.kill_one(self.hosts[0])
            wait_for(lambda: not self.shell('squeue --noheader').stdout, 'the end of the job',
                     DEADLINE)
            partly = self.found()
            self.assertLess(len(partly), len(self.expected))
            self.shell('sbatch --wait job.sh')
            self.check_lines('lines_*.jsonl')
            print('Slurm: %d lines after the kill, %d after the second start' % (
                len(partly), len(self.found())))
            print('\n'.join(line[:150] + ' ...' for line in self.found('lines_0.jsonl')[:3]))
            print(self.shell('%s --merge lines_*.jsonl | tail -n 22 | cut -c 1-150'
                             % bag_bounds_testing.BAG_BOUNDS).stdout)


if __name__ == '__main__':
    COMMAND = unshare_command()
    if os.geteuid() != 0 or COMMAND is None:
        print('skipped: no network namespaces, or no root; no recipe was run')
    elif INSIDE not in os.environ:
        os.execvpe(COMMAND[0], [*COMMAND, sys.executable, *sys.argv], dict(os.environ, **{INSIDE: '1'}))
    else:
        main()
