<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- What the manual refers to in CGAL's own: pages of its online manual, by the names that Doxygen gives them. -->
<tagfile>
  <compound kind="class"><name>FaceGraph</name><filename>BGL/classFaceGraph.html</filename></compound>
  <compound kind="class"><name>FaceListGraph</name><filename>BGL/classFaceListGraph.html</filename></compound>
  <compound kind="class"><name>HalfedgeListGraph</name><filename>BGL/classHalfedgeListGraph.html</filename></compound>
  <compound kind="class"><name>VertexListGraph</name><filename>BGL/classVertexListGraph.html</filename></compound>
  <compound kind="class"><name>Kernel</name><filename>Kernel_23/classKernel.html</filename></compound>
  <compound kind="class"><name>ConstRange</name><filename>Circulator/classConstRange.html</filename></compound>
  <compound kind="class"><name>CGAL::Kernel_traits</name><filename>Kernel_23/structCGAL_1_1Kernel__traits.html</filename></compound>
  <compound kind="class"><name>CGAL::Simple_cartesian</name><filename>Kernel_23/structCGAL_1_1Simple__cartesian.html</filename></compound>
  <compound kind="class"><name>CGAL::Exact_predicates_exact_constructions_kernel</name><filename>Kernel_23/classCGAL_1_1Exact__predicates__exact__constructions__kernel.html</filename></compound>
  <compound kind="class"><name>CGAL::Exact_predicates_inexact_constructions_kernel</name><filename>Kernel_23/classCGAL_1_1Exact__predicates__inexact__constructions__kernel.html</filename></compound>
  <compound kind="class"><name>CGAL::Sequential_tag</name><filename>STL_Extension/structCGAL_1_1Sequential__tag.html</filename></compound>
  <compound kind="class"><name>CGAL::Parallel_tag</name><filename>STL_Extension/structCGAL_1_1Parallel__tag.html</filename></compound>
  <compound kind="class"><name>CGAL::Surface_mesh</name><filename>Surface_mesh/classCGAL_1_1Surface__mesh.html</filename></compound>
  <compound kind="class"><name>CGAL::Polyhedron_3</name><filename>Polyhedron/classCGAL_1_1Polyhedron__3.html</filename></compound>
  <compound kind="namespace">
    <name>CGAL</name>
    <filename>Manual/namespaceCGAL.html</filename>
    <class kind="class">CGAL::Kernel_traits</class>
    <class kind="class">CGAL::Simple_cartesian</class>
    <class kind="class">CGAL::Exact_predicates_exact_constructions_kernel</class>
    <class kind="class">CGAL::Exact_predicates_inexact_constructions_kernel</class>
    <class kind="class">CGAL::Sequential_tag</class>
    <class kind="class">CGAL::Parallel_tag</class>
    <class kind="class">CGAL::Surface_mesh</class>
    <class kind="class">CGAL::Polyhedron_3</class>
    <member kind="typedef"><type>unspecified_type</type><name>Parallel_if_available_tag</name>
      <anchorfile>STL_Extension/group__PkgSTLExtensionRef.html</anchorfile><anchor></anchor><arglist></arglist></member>
  </compound>
  <compound kind="namespace">
    <name>CGAL::Polygon_mesh_processing</name>
    <filename>Polygon_mesh_processing/namespaceCGAL_1_1Polygon__mesh__processing.html</filename>
    <member kind="function"><type>void</type><name>compute_vertex_normals</name>
      <anchorfile>Polygon_mesh_processing/group__PMP__normal__grp.html</anchorfile><anchor></anchor><arglist>()</arglist></member>
    <member kind="function"><type>void</type><name>detect_sharp_edges</name>
      <anchorfile>Polygon_mesh_processing/group__PMP__detect__features__grp.html</anchorfile><anchor></anchor><arglist>()</arglist></member>
    <member kind="function"><type>void</type><name>smooth_shape</name>
      <anchorfile>Polygon_mesh_processing/group__PMP__meshing__grp.html</anchorfile><anchor></anchor><arglist>()</arglist></member>
    <member kind="function"><type>void</type><name>random_perturbation</name>
      <anchorfile>Polygon_mesh_processing/group__PMP__meshing__grp.html</anchorfile><anchor></anchor><arglist>()</arglist></member>
    <member kind="function"><type>void</type><name>isotropic_remeshing</name>
      <anchorfile>Polygon_mesh_processing/group__PMP__meshing__grp.html</anchorfile><anchor></anchor><arglist>()</arglist></member>
    <member kind="function"><type>void</type><name>fair</name>
      <anchorfile>Polygon_mesh_processing/group__PMP__meshing__grp.html</anchorfile><anchor></anchor><arglist>()</arglist></member>
    <member kind="function"><type>void</type><name>remove_degenerate_faces</name>
      <anchorfile>Polygon_mesh_processing/group__PMP__repairing__grp.html</anchorfile><anchor></anchor><arglist>()</arglist></member>
    <member kind="function"><type>void</type><name>bounded_error_Hausdorff_distance</name>
      <anchorfile>Polygon_mesh_processing/group__PMP__distance__grp.html</anchorfile><anchor></anchor><arglist>()</arglist></member>
  </compound>
  <compound kind="group"><name>bgl_namedparameters</name><title>Named Parameters</title><filename>BGL/group__bgl__namedparameters.html</filename></compound>
  <compound kind="group"><name>PkgPolygonMeshProcessingRef</name><title>Polygon Mesh Processing Reference</title><filename>Polygon_mesh_processing/group__PkgPolygonMeshProcessingRef.html</filename></compound>
</tagfile>
