// SPDX-FileCopyrightText: 2026 The link_bounds authors
// SPDX-License-Identifier: BSD-3-Clause
// The text of --help.
#include "tools/urdf_bounds/request/urdf_bounds_options.h"

namespace link_bounds {

const char* const kUsage =
    R"(usage: urdf_bounds FILE.urdf|- [joint:=value ...] [options]

Prints the exact axis-aligned bounding box of every link of a robot that has geometry, and of the
whole robot, in the frame of its root link. Needs no ROS master.

  FILE.urdf           the robot; relative mesh names start at its folder
  -                   read the robot from standard input; relative mesh names start here
  joint:=value        position of a movable joint [rad or m]; 0 if not given; joints that mimic
                      another one follow it
  joint:=a..b         for --reach and --pairs: the joint moves from a to b, whatever its limits
  joint.x:=...        a value or range of a floating joint (x, y, z, roll, pitch, yaw) or of a
                      planar one (x, y, yaw, in its plane)
  --geometry G        visual (default), collision or both
  --representation R  min-max (default): smallest and largest corner
                      min-width: smallest corner and widths
                      center-radius: centre and half-extents
  --format F          table (default): rounded to micrometres
                      csv: link,a_x,a_y,a_z,b_x,b_y,b_z, of --poses and --reach link,min_x,...;
                      groups last as group:NAME
                      json: always min-max; also says what is incomplete and why
                      markers: of --reach, a visualization_msgs/MarkerArray for rostopic pub -f -
                      srdf: of --pairs, disable_collisions elements of what is proven; with --srdf
                      FILE the whole SRDF with these
  --volume V          instead of the box, for every link but not for the whole robot:
                      sphere: centre and radius of a bounding sphere
                      obb: centre, full widths and orientation (a quaternion) of a small box that
                      turns with the link
  --distances LIMIT   also how far links are apart: the pairs whose proven distance is at most
                      LIMIT [m], but none that are rigidly connected or neighbours by one joint;
                      csv: only these, as first,second,distance,distance_max,on_first_x, ...
  --poses FILE        many poses: a csv file with names of joints in its first line and a pose in each
                      further one [rad, m], also a column time [s]; - is standard input; prints the
                      boxes around all rows, with --distances each pair where it is nearest, and how
                      many rows have a contact: a distance of 0
  --columns A,B       of --poses: the names of the columns; the file then has no line of names
  --series FILE       of --poses: also writes each row: row,time, then the columns of csv
  --path              of --poses: whether the robot collides on its way from row to row, with proof
                      or witness; linear in the joints, or with columns NAME.velocity and time cubic,
                      with NAME.acceleration of fifth order, as joint_trajectory_controller;
                      csv: from,to,verdict,clearance,nearest,first,second,at,pose
  --objects FILE      of --path: what stands around, as YAML in the frame of the root link:
                      NAME: {type: CUBE, pose: ..., scale: ...}, fields as in a Marker
  --jobs N            of --poses: threads (default: one per core); the results are the same
  --reach             instead of the boxes of one pose: boxes that the links never leave while the
                      joints move within their limits, proven, and poses that attain each face
  --pairs             which links can collide in any pose within the limits, with proof or witness;
                      csv: first,second,verdict,clearance,nearest,pose,poses
  --accuracy M        of --reach and --pairs: stop as soon as what is proven is within M of a pose
                      that was found [m] (default 0.01)
  --budget SECONDS    of --reach, --pairs and --path: stop then, with what is proven by then (default 60);
                      Ctrl-C does the same
  --clearance M       of --pairs and --path: links collide where they are nearer than M [m] (default 0)
  --touching M        of --pairs: links that are never farther apart than M are TOUCHING [m]
                      (default 0.0001)
  --adjacent          of --pairs: also examines links with one joint between them
  --srdf FILE         of --pairs: checks the disable_collisions of a SRDF;
                      of --path: leaves out the pairs that it disables
  --certificate FILE  of --reach, --pairs and --path: writes why the links never leave their boxes, why
                      each NEVER holds, or why each SAFE does, for scripts/check_certificate of
                      the repository, which no package has
  --accept-sampled    of --format srdf: also disables pairs that collided in all poses tried
  --base fixed        of --reach and --pairs: floating and planar joints of the root stay at 0;
                      without a range, nothing is proven of what depends on such a joint
  --verbose           the memory that each mesh takes, and the time of a segment of --path, on
                      standard error
  --strict            exit with 2 if any geometry could not be used; of --poses: with 1 if a joint has
                      no column, a column is none of a joint, or a value is no number or is outside
                      the limits of its joint, also between two rows of --path
  --allow-incomplete  what is incomplete or not decided does not change the exit code, unless
                      Ctrl-C or SIGTERM ended the run
  -h, --help          this text
  --version           the version of link_bounds

Lengths are metres. Exit code, the first that applies:
  1  unusable robot, SRDF, table or arguments
  3  the SRDF disables a pair that can collide; a row of --poses has a contact; a segment of
     --path COLLIDES
  4  of --distances, --poses, --path, --reach and --pairs without --allow-incomplete: a mesh is
     missing or something else is incomplete, a pair or segment is UNDECIDED, the accuracy was not
     reached, a row was left out, or nothing was looked at; of any run that was interrupted
  2  see --strict
  0  everything was answered and holds
)";

}  // namespace link_bounds
