#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
"""A depth camera that sees the demo's arm, a cup between its fingers, and a table with a ball.

Draws the visual geometry of robot_description, whose poses come from tf, and publishes the cloud
depth_camera/points (sensor_msgs/PointCloud2, organised, in colour, frame depth_camera) and the
static transform of the camera. Parameters: ~rate (Hz, default 2), ~width (pixels, default 200).
"""

import math
import os
import sys

import numpy
import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import PointCloud2, PointField

sys.path.append(os.path.dirname(os.path.realpath(__file__)))
from demo_arguments import (  # noqa: E402
    check_arguments, number_parameter, robot_description, run, run_regularly)
from solid_triangles import box, lathe, link_triangles, sphere  # noqa: E402

ROOT, HAND, FRAME = 'base', 'gripper', 'depth_camera'
PLACE, TARGET = (1.45, -0.75, 1.15), (0.15, 0.0, 0.6)  # of the camera and where it looks [m]
ASPECT, FIELD = 0.75, math.radians(58)   # height / width, and the horizontal field of view
NEAR = 0.1  # m
ARM = (0.93, 0.52, 0.16)  # red, green, blue
CUP = [(0.085, 0), (0.085, 0.026), (0.165, 0.034), (0.165, 0.031), (0.088, 0.023), (0.088, 0)]


def scene():
    """[(frame, triangles, colour)] of what is no robot."""
    return [(ROOT, box((2.4, 2.4, 0.02)) + (0, 0, -0.03), (0.80, 0.82, 0.85)),
            (ROOT, sphere(0.12) + (0.45, 0.45, 0.12), (0.35, 0.65, 0.35)),
            (ROOT, box((0.2, 0.3, 0.25)) + (-0.5, 0.5, 0.125), (0.75, 0.60, 0.40)),
            (HAND, lathe(CUP), (0.15, 0.35, 0.85))]


def matrix(transform):
    """4 x 4, of a geometry_msgs/Transform."""
    q, t = transform.rotation, transform.translation
    x, y, z, w = q.x, q.y, q.z, q.w
    return numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), t.x],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), t.y],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), t.z],
        [0, 0, 0, 1]])


def camera_pose():
    """From the camera, z ahead and y down, to the root."""
    z = numpy.subtract(TARGET, PLACE)
    z /= numpy.linalg.norm(z)
    x = numpy.cross(z, (0, 0, 1))
    x /= numpy.linalg.norm(x)
    pose = numpy.eye(4)
    pose[:3, :3] = numpy.stack([x, numpy.cross(z, x), z], axis=1)
    pose[:3, 3] = PLACE
    return pose


def static_transform(pose):
    """The quaternion from the trace, which is not near -1 for this camera."""
    result = TransformStamped(child_frame_id=FRAME)
    result.header.frame_id = ROOT
    t, q = result.transform.translation, result.transform.rotation
    t.x, t.y, t.z = pose[:3, 3]
    q.w = math.sqrt(max(0, 1 + numpy.trace(pose[:3, :3]))) / 2
    q.x = (pose[2, 1] - pose[1, 2]) / (4 * q.w)
    q.y = (pose[0, 2] - pose[2, 0]) / (4 * q.w)
    q.z = (pose[1, 0] - pose[0, 1]) / (4 * q.w)
    return result


class Camera:
    def __init__(self, width):
        self.width, self.height = width, round(ASPECT * width)
        self.focal = width / 2 / math.tan(FIELD / 2)  # pixels
        u, v = numpy.meshgrid(numpy.arange(self.width), numpy.arange(self.height))
        self.rays = numpy.stack([(u + 0.5 - self.width / 2) / self.focal,
                                 (v + 0.5 - self.height / 2) / self.focal,
                                 numpy.ones(u.shape)], axis=-1)

    def draw(self, triangles, colour, depth, picture):
        """Changes depth and colour where a triangle, in the frame of the camera, is nearer."""
        triangles = triangles[(triangles[:, :, 2] > NEAR).all(axis=1)]
        normals = numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        places = triangles[:, :, :2] / triangles[:, :, 2:] * self.focal
        places += (self.width / 2, self.height / 2)
        low = numpy.clip(numpy.ceil(places.min(axis=1) - 0.5), 0, None).astype(int)
        high = numpy.floor(places.max(axis=1) + 0.5).astype(int)
        high = numpy.minimum(high, (self.width, self.height))
        seen = (low < high).all(axis=1)  # many triangles are between two rays
        for corners, normal, (u0, v0), (u1, v1) in zip(triangles[seen], normals[seen], low[seen],
                                                       high[seen]):
            rays = self.rays[v0:v1, u0:u1]
            sides = [rays @ numpy.cross(corners[i], corners[(i + 1) % 3]) for i in range(3)]
            inside = (numpy.minimum.reduce(sides) >= 0) | (numpy.maximum.reduce(sides) <= 0)
            along = rays @ normal
            with numpy.errstate(divide='ignore', invalid='ignore'):
                z = (normal @ corners[0]) / along
            view = depth[v0:v1, u0:u1]
            nearer = inside & (along != 0) & (z > NEAR) & (z < view)
            view[nearer] = z[nearer]
            facing = abs(normal @ corners[0]) / max(
                numpy.linalg.norm(normal) * numpy.linalg.norm(corners[0]), 1e-12)
            picture[v0:v1, u0:u1][nearer] = numpy.multiply(colour, 255 * (0.35 + 0.65 * facing))

    def cloud(self, parts, stamp):
        """`parts` are triangles in the frame of the camera, each with a colour."""
        depth = numpy.full((self.height, self.width), numpy.inf)
        picture = numpy.zeros((self.height, self.width, 3))
        for triangles, colour in parts:
            self.draw(triangles, colour, depth, picture)
        depth[numpy.isinf(depth)] = numpy.nan
        points = numpy.zeros((self.height, self.width), [('xyz', '<f4', 3), ('bgr', 'u1', 4)])
        points['xyz'] = self.rays * depth[:, :, None]
        points['bgr'][:, :, :3] = picture[:, :, ::-1]
        message = PointCloud2(width=self.width, height=self.height, point_step=16,
                              row_step=16 * self.width)
        message.header.stamp, message.header.frame_id = stamp, FRAME
        message.fields = [PointField(name, 4 * i, PointField.FLOAT32, 1)
                          for i, name in enumerate(['x', 'y', 'z', 'rgb'])]
        message.data = points.tobytes()
        return message


def main():
    check_arguments(__doc__)
    rospy.init_node('depth_camera')
    bodies = scene() + [(link, triangles, ARM) for link, triangles in
                        link_triangles(robot_description('to see')).items()]
    camera = Camera(int(number_parameter('width', 200, 0, 'a number of pixels')))
    tf = tf2_ros.Buffer()
    tf2_ros.TransformListener(tf)
    broadcaster = tf2_ros.StaticTransformBroadcaster()
    pose = camera_pose()
    broadcaster.sendTransform(static_transform(pose))
    publisher = rospy.Publisher('~points', PointCloud2, queue_size=2)

    def publish():
        try:
            stamp = max(tf.get_latest_common_time(ROOT, frame) for frame, _, _ in bodies)
            parts = []
            for frame, triangles, colour in bodies:
                # The pose at one time for all; static links have it at any.
                placed = numpy.linalg.inv(pose) @ matrix(
                    tf.lookup_transform(ROOT, frame, stamp).transform)
                parts.append((triangles @ placed[:3, :3].T + placed[:3, 3], colour))
        except tf2_ros.TransformException:
            return  # the arm has not moved yet
        publisher.publish(camera.cloud(parts, stamp))

    run_regularly(2, publish, at_once=False)


if __name__ == '__main__':
    run(main)
