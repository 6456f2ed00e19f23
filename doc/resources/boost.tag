<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- The concepts of Boost's property maps, by the pages that describe them. -->
<tagfile>
  <compound kind="class"><name>ReadablePropertyMap</name><filename>property_map/doc/ReadablePropertyMap.html</filename></compound>
  <compound kind="class"><name>WritablePropertyMap</name><filename>property_map/doc/WritablePropertyMap.html</filename></compound>
  <compound kind="class"><name>ReadWritePropertyMap</name><filename>property_map/doc/ReadWritePropertyMap.html</filename></compound>
</tagfile>
